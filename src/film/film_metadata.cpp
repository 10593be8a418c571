#include "film/film_metadata.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/named_value.h"
#include "film/filter_footprint.h"

namespace emulsion {

namespace {

/// Of luminances: means over the pixels that have a value, in cd/m^2.
struct MeanLuminance {
    double plain_cdm2 = 0.0;       ///< of the means of samples
    double controlled_cdm2 = 0.0;  ///< of what is done with them
};

/// Calls camera_value(sums) for what a pixel shows of its camera samples.
template <class CameraValue>
MeanLuminance mean_luminance(const FilmContents<ExactSums>& contents, const FilmOptions& options,
                             const CameraValue& camera_value) {
    MeanLuminance mean;
    double pixels = 0.0;
    for (std::size_t i = 0; i < contents.pixels.size(); ++i) {
        const PixelSums sums = sums_of(contents, i);
        const std::optional<XYZd> plain = mean_of(sums), controlled = camera_value(sums);
        if (!plain || !controlled) continue;
        mean.plain_cdm2 += plain->y;
        mean.controlled_cdm2 += controlled->y;
        pixels += 1.0;
    }
    if (pixels == 0.0) return mean;
    const double scale = 1.0 / (pixels * imaging_ratio(options.sensor));
    return {scale * mean.plain_cdm2, scale * mean.controlled_cdm2};
}

std::string percent_text(double part, double whole) {
    return whole > 0.0 ? fmt::format("{:.3g} %", 100.0 * part / whole) : "unknown part";
}

std::string bias_text(const NoFireflyControl& /*none*/, const FilmContents<ExactSums>& /*contents*/,
                      const FilmOptions& /*options*/) {
    return {};
}

std::string bias_text(const LuminanceClamp& clamp, const FilmContents<ExactSums>& contents,
                      const FilmOptions& options) {
    const ClampedSamples& clamped = contents.counts.clamped;
    // Per weight, as the pixels' own means are.
    double weights = 0.0;
    for (const ExactFilmPixel& pixel : contents.pixels) weights += pixel.sums().weight;
    const double removed_cdm2 =
        weights > 0.0 ? clamped.removed_luminance.value() / (weights * imaging_ratio(options.sensor)) : 0.0;
    const double left_cdm2 = mean_luminance(contents, options, mean_of).plain_cdm2;
    return fmt::format("{}; {} of {} samples were scaled down; mean luminance lowered by {:.4g} cd/m^2, {}",
                       to_text(clamp), clamped.count, contents.counts.samples, removed_cdm2,
                       percent_text(removed_cdm2, left_cdm2 + removed_cdm2));
}

std::string bias_text(const MedianOfMeans& median, const FilmContents<ExactSums>& contents,
                      const FilmOptions& options) {
    FilmOptions sums_only = options;
    sums_only.sensor.camera.reset();  // long past: no reason to fit it again
    sums_only.sensor.white_balance.reset();
    const FilmSetup setup(sums_only);
    const MeanLuminance mean =
        mean_luminance(contents, options, [&](const PixelSums& sums) { return camera_value_of(sums, setup); });
    const double bias_cdm2 = mean.controlled_cdm2 - mean.plain_cdm2;
    return fmt::format("{}; mean luminance changed by {:.4g} cd/m^2, {}", to_text(median), bias_cdm2,
                       percent_text(bias_cdm2, mean.plain_cdm2));
}

std::uint64_t least_samples_taken(const FilmContents<ExactSums>& contents, const FilmOptions& options,
                                  const FilmProvenance& provenance) {
    if (const SamplesTaken taken = samples_taken(provenance); taken.most > 0) return taken.least;
    if (options.filter_use != FilterUse::splatted) return min_samples_per_pixel(contents);
    const PixelBounds places = FilterFootprint(options.filter).places_that_reach(bounds_of(options));
    return contents.counts.samples /
           (static_cast<std::uint64_t>(places.width()) * static_cast<std::uint64_t>(places.height()));
}

}  // namespace

std::string firefly_text(const FilmContents<ExactSums>& contents, const FilmOptions& options) {
    return std::visit([&](const auto& control) { return bias_text(control, contents, options); },
                      options.firefly_control);
}

void update_counts(const FilmContents<ExactSums>& contents, const FilmOptions& options,
                   const FilmProvenance& provenance, FilmMetadata& metadata) {
    const DroppedSamples& dropped = contents.counts.dropped;
    metadata.samples_per_pixel = static_cast<std::int64_t>(least_samples_taken(contents, options, provenance));
    metadata.sample_count = contents.counts.samples;
    metadata.dropped_nan_count = dropped.count(DroppedKind::nan);
    metadata.dropped_infinite_count = dropped.count(DroppedKind::infinite);
    metadata.dropped_negative_luminance_count = dropped.count(DroppedKind::negative_luminance);
    metadata.faint_count = contents.counts.faint;
    metadata.firefly_control = firefly_text(contents, options);
}

FilmMetadata metadata_of(const FilmContents<ExactSums>& contents, const FilmOptions& options,
                         const FilmProvenance& provenance, FilmMetadata run) {
    update_counts(contents, options, provenance, run);
    run.sampling = provenance.sampling;
    run.filter = to_text(options.filter);
    const std::string text = to_text(options);
    run.film = text.substr(text.find(' ') + 1) + " " + to_text(options.sensor);
    return run;
}

FilmMetadata metadata_of(const Film& film, const FilmProvenance& provenance, FilmMetadata run) {
    return film.with_contents([&](const FilmContents<ExactSums>& contents) {
        return metadata_of(contents, film.options(), provenance, std::move(run));
    });
}

FilmMetadata metadata_of(const Film& film, FilmMetadata run) { return metadata_of(film, {}, std::move(run)); }

}  // namespace emulsion
