#pragma once
// What `emulsion render` is told on its command line, over what the scene says.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/model_choice.h"
#include "cli/exr_output_options.h"
#include "core/image.h"
#include "develop/pipeline.h"
#include "film/exr_file.h"
#include "film/film_options.h"
#include "film/sample_ranges.h"
#include "pathtracer/render.h"

namespace CLI {
class App;
}

namespace emulsion::cli {

/// One of `count` equal shares of a render's samples, from 1.
struct Shard {
    int number = 1, count = 1;
};

/// Of samples [0, samples_per_pixel).
[[nodiscard]] SampleRange samples_of(const Shard& shard, int samples_per_pixel) noexcept;

struct RenderSettings {
    std::filesystem::path scene, output, png;  ///< the last two are empty if not given

    // Unset: as the scene says.
    std::optional<int> samples_per_pixel;
    std::optional<std::pair<int, int>> resolution_px;
    std::optional<PixelBounds> crop;
    std::optional<std::uint64_t> seed;
    std::optional<Filter> filter;
    std::optional<std::string> observer;
    std::optional<std::filesystem::path> sensor;  ///< a camera's measured curves

    FilterUse filter_use = FilterUse::importance_sampled;
    FilmVariance variance = FilmVariance::none;
    std::optional<SpectralBuckets> spectrum;
    std::vector<AuxLayer> aux;
    FireflyControl firefly_control;

    ModelChoice model;
    int threads = 0;
    std::optional<double> until;  ///< standard error of colour, CIEDE2000, > 0
    std::optional<Shard> shard;
    std::optional<double> checkpoint_s;  ///< > 0
    bool resume = false;

    ExrOutput exr;
    bool quiet = false;
    Pipeline pipeline;
};

/// Adds the flags, which are read into `settings`; it must outlive the parsing.
void add_render_options(CLI::App& command, RenderSettings& settings);

/// Writes what the settings say over the scene's own. \throws IoError if the sensor's curves can't be read, and
/// CLI::ValidationError for a crop window beyond the frame.
void apply(const RenderSettings& settings, Scene& scene);

// For a scene that they were applied to.
/// \throws CLI::ValidationError for a firefly control that the scene's exposure takes out of its range.
[[nodiscard]] FilmOptions film_options(const RenderSettings& settings, const Scene& scene);
/// \throws std::runtime_error if a shard has no samples.
[[nodiscard]] RenderOptions render_options(const RenderSettings& settings, const Scene& scene);
[[nodiscard]] ExrOptions exr_options(const RenderSettings& settings, const Scene& scene);

}  // namespace emulsion::cli
