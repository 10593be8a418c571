#pragma once
// The files of a render: the picture, and the film state from which a later run goes on.

#include <filesystem>

namespace emulsion::cli {

/// Whether a name ends in ".film.exr".
[[nodiscard]] bool is_state_name(const std::filesystem::path& path);

/// The state's name for a render that writes `output`: NAME.film.exr beside NAME.exr; `output` itself if it is a state.
[[nodiscard]] std::filesystem::path state_name(const std::filesystem::path& output);

}  // namespace emulsion::cli
