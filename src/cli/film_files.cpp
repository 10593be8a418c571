#include "cli/film_files.h"

namespace emulsion::cli {

bool is_state_name(const std::filesystem::path& path) { return path.string().ends_with(".film.exr"); }

std::filesystem::path state_name(const std::filesystem::path& output) {
    if (is_state_name(output)) return output;
    std::filesystem::path state = output;
    return state.replace_extension(".film.exr");
}

}  // namespace emulsion::cli
