#pragma once
// What the names of files say of their kind. Capital letters are as good as small ones.

#include <filesystem>
#include <string_view>

namespace emulsion::cli {

/// Whether a name ends in `extension`, which is written small, with its dot, and stands behind something.
[[nodiscard]] bool has_extension(const std::filesystem::path& name, std::string_view extension);

/// Whether a name ends in ".film.exr".
[[nodiscard]] bool is_state_name(const std::filesystem::path& name);

/// The state's name for a render that writes `output`: NAME.film.exr beside NAME.exr; `output` itself if it is a state.
[[nodiscard]] std::filesystem::path state_name(const std::filesystem::path& output);

}  // namespace emulsion::cli
