#pragma once
// Scene to film.

#include <atomic>
#include <cstdint>

#include "film/film.h"
#include "pathtracer/prepared_scene.h"

namespace emulsion {

struct RenderOptions {
    int samples_per_pixel = 16;  ///< in [1, 2^24]
    std::uint64_t seed = 0;      ///< another seed, another independent picture
    int wavelengths = 4;         ///< per path; one of kWavelengthCounts
    int threads = 0;             ///< >= 0; 0: one per hardware thread
};

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const RenderOptions& options);

/// Shared with whoever waits for the picture.
struct RenderProgress {
    std::atomic<std::int64_t> samples_done{
        0};                         ///< paths finished and in the film, of width * height * samples per pixel
    std::atomic<bool> stop{false};  ///< set it, and render() returns soon, with what is done in the film
};

/// Adds options.samples_per_pixel paths to every pixel of the film, whose size gives the resolution. The film's sums
/// depend on scene, seed, sample count and the build: every number of threads gives the same bits. (Embree picks its
/// instructions by the processor: another type of processor may differ by rounding.) Samples are added in rounds over
/// the whole picture, the first of one sample per pixel: from then on a picture that is stopped early is whole.
/// \throws std::invalid_argument as validate() does.
void render(const PreparedScene& scene, const RenderOptions& options, Film& film, RenderProgress& progress);

/// The film that a scene asks for.
[[nodiscard]] FilmOptions film_options(const Scene& scene);

}  // namespace emulsion
