#pragma once
// What `emulsion compare` compares: pictures in files, and scenes that are rendered for it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "analysis/model_choice.h"
#include "compare/compared_picture.h"

namespace emulsion::cli {

/// How scenes are rendered; unset: as the scene says.
struct SceneRenderSettings {
    std::optional<int> samples_per_pixel;  ///< >= 2
    std::uint64_t seed = 0;
    std::optional<std::pair<int, int>> resolution_px;
    int threads = 0;
};

/// SCENE.pbrt@MODEL
struct SceneWithModel {
    std::filesystem::path scene;
    ModelChoice model;
};

/// If the text is one: what precedes the last @ ends in .pbrt, or in .pbrt.gz.
/// \throws std::invalid_argument as parse_model_choice().
[[nodiscard]] std::optional<SceneWithModel> parse_scene_with_model(const std::string& text);

/// The file that A or B names. \throws as parse_scene_with_model().
[[nodiscard]] std::filesystem::path file_of(const std::string& text);

/// Which of the two; their noise must be independent.
enum class CompareSide { a, b };

/// What is given for one of the two.
struct CompareInput {
    std::string text;             ///< a file, or a scene with a model
    std::filesystem::path again;  ///< a file with the same picture, of another seed; empty: none
};

/// Reads a picture, or renders a scene; warns of what there is to be said. Of two pictures it is the mean, and how far
/// they are apart tells its noise, whatever the sampler (mean_of()). A scene is always rendered twice, with half of the
/// samples and another seed each. The four seeds of A and B are those of no film that anybody has rendered with a seed
/// below 2^32.
/// \throws IoError, SceneError, and std::invalid_argument for an unknown model, or one that the scene
/// can't have, and for two pictures that don't go together.
[[nodiscard]] ComparedPicture compare_input(const CompareInput& input, CompareSide side,
                                            const SceneRenderSettings& settings);

}  // namespace emulsion::cli
