#pragma once
// Scene to film.

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "film/film.h"
#include "film/film_provenance.h"
#include "pathtracer/film_in_progress.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/transport_model.h"

namespace emulsion {

inline constexpr int kMostSamplesPerPixel = 1 << 24;

struct RenderOptions {
    /// In [1, kMostSamplesPerPixel]; of the whole picture: a stratified sampler's strata depend on it.
    int samples_per_pixel = 16;
    /// Which of them to render, by index; inside [0, samples_per_pixel), not empty. Unset: all.
    std::optional<SampleRange> samples = std::nullopt;
    std::uint64_t seed = 0;     ///< another seed, another independent picture
    TransportModel model = {};  ///< that the scene is prepared for
    int threads = 0;            ///< >= 0; 0: one per hardware thread
    /// Standard error of colour, CIEDE2000, at which a tile stops before it has all samples: pathtracer/stopping_rule.h
    /// says how that is known, and why it leaves the picture unbiased. Finite, > 0. Unset: none stops.
    std::optional<double> until = std::nullopt;
};

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const RenderOptions& options);

/// Why models of fixed channels, which know nothing but CIE 1931 XYZ, can't fill this film; empty: they can.
/// \throws std::invalid_argument for an observer that doesn't exist.
[[nodiscard]] std::string why_not_of_channels(const FilmOptions& film);

/// The samples that these options ask for.
[[nodiscard]] SampleRange samples_of(const RenderOptions& options) noexcept;

/// Shared with whoever waits for the picture.
struct RenderProgress {
    std::atomic<std::int64_t> samples_done{0};   ///< paths finished and in the film, of FilmInProgress::missing_paths
    std::atomic<std::int64_t> samples_saved{0};  ///< of the same: paths of tiles that have stopped before
    std::atomic<bool> stop{false};               ///< set it, and render() returns soon, with what is done in the film
};

/// What a film of this scene and these options is of, before it has any samples: films of the same scene and sampling
/// can go on from, and be added to, each other.
[[nodiscard]] FilmProvenance provenance_of(const Scene& scene, const RenderOptions& options);

/// Adds the samples of samples_of(options) that the film does not have yet to each pixel that its picture needs; goes
/// on with a partial round where it was left. The film's size and crop window are the picture's, and layers that it
/// asks for are filled in, by the names of known_aux_layers(): pathtracer/aux_layers.h says what with.
///
/// The film's sums depend on scene, seed, samples and the build: every number of threads, every crop window and every
/// way of sharing samples out over runs gives the same bits. (Embree picks its instructions by the processor: another
/// type of processor may differ by rounding.) Samples are added in rounds over the whole picture, the first of one
/// sample per pixel: from then on a picture that is stopped early is whole. With options.until, tiles have as many
/// samples as they need and no more than that; where a film goes on from a state, the noise pair of the samples that it
/// has is traced again. The bits then depend on the crop window, too.
/// \throws std::invalid_argument as validate() does; if the film has samples of another scene or sampling; and for an
/// auxiliary layer of another name. So if the
/// scene isn't prepared for the model; for models of fixed channels, which know nothing but CIE 1931 XYZ, if the
/// film has another observer, a camera, a white balance or spectral buckets; and with options.until, as
/// validate_stopping().
void render(const PreparedScene& scene, const RenderOptions& options, FilmInProgress& film, RenderProgress& progress);
/// The same with a film that has no samples of this scene yet, and whose account nobody needs.
void render(const PreparedScene& scene, const RenderOptions& options, Film& film, RenderProgress& progress);

/// The film that a scene asks for.
[[nodiscard]] FilmOptions film_options(const Scene& scene);

}  // namespace emulsion
