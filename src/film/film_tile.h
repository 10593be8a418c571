#pragma once
// A rectangle of the film that one thread fills, without locks; BasicFilm::merge then adds it to the film.

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/clamped_samples.h"
#include "film/dropped_samples.h"
#include "film/film_channels.h"
#include "film/film_setup.h"
#include "film/film_sums.h"
#include "film/spectral_buckets.h"
#include "film/splat_block.h"
#include "film/vectors.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

/// Made by BasicFilm::make_tile. Pixels and places are those of the full frame, not of the tile: pixel (x, y) covers
/// [x, x + 1) x [y, y + 1). Sums is one of FilmSums.
///
/// Samples come in as spectra (N wavelengths of one path: radiance in W m^-2 sr^-1 nm^-1, densities in 1/nm) or as XYZ
/// (Y in cd/m^2 times the imaging ratio, if the film is to have one; film/rgb_input.h makes XYZ of RGB). One with a
/// NaN, an infinity or a negative luminance (of the light; the XYZ that a camera or a white balance makes of it may be
/// negative) is counted in dropped() and adds neither value nor weight.
template <class Sums>
class BasicFilmTile {
  public:
    using Pixel = typename Sums::TilePixel;
    /// From so many samples in a pixel on, the film takes it for saturated.
    static constexpr std::uint32_t kMostSamples = 1u << 31;

    /// `places` must have pixels. The tile holds the film's pixels that samples there reach: a border more, if the film
    /// splats.
    BasicFilmTile(PixelBounds places, std::shared_ptr<const FilmSetup> setup);

    /// Of the film that it was made for.
    [[nodiscard]] const FilmSetup& setup() const noexcept { return *setup_; }
    /// Where samples belong.
    [[nodiscard]] const PixelBounds& places() const noexcept { return places_; }
    /// The pixels that the tile holds.
    [[nodiscard]] const PixelBounds& bounds() const noexcept { return bounds_; }

    // --- Camera samples of filter importance sampling: they belong to one pixel of bounds().

    /// Weights are signed, and of mean 1 if they come from a FilterSampler.
    template <int N>
    void add(int x, int y, const SampledWavelengths<N>& wavelengths, const SampledSpectrum<N>& radiance,
             float weight) noexcept {
        const SensorSample sample = sensor_->sense(wavelengths, radiance);
        const std::size_t i = index(x, y);
        accumulate(i, x, y, sample.xyz, sample.luminance, weight);
        if (has_buckets_) [[unlikely]]
            add_buckets(i, sample, {wavelengths.lambda_nm, radiance.value, wavelengths.pdf}, weight);
    }
    void add(int x, int y, XYZ value, float weight) noexcept { accumulate(index(x, y), x, y, value, value.y, weight); }

    // --- Camera samples that are splatted: they go into every pixel that the film's filter reaches from their place,
    // which must lie in places() and be drawn uniformly. For films whose filter_use is splatted.

    template <int N>
    void add_at(float x_px, float y_px, const SampledWavelengths<N>& wavelengths,
                const SampledSpectrum<N>& radiance) noexcept {
        const SensorSample sample = sensor_->sense(wavelengths, radiance);
        spread(x_px, y_px, sample, {wavelengths.lambda_nm, radiance.value, wavelengths.pdf});
    }
    void add_at(float x_px, float y_px, XYZ value) noexcept { spread(x_px, y_px, {value, value.y}, {}); }

    // --- Light splats: what a light tracer's path sends to a place of the film. For films with light_splats. The mean,
    // over paths, of the sum of the values that arrive in a region is the integral of the picture over that region, in
    // pixels: values are XYZ (or radiance) times an area in pixels. Places outside places() are ignored, as most paths
    // miss the film. Tell the film the number of paths: BasicFilm::add_light_paths.

    template <int N>
    void splat(float x_px, float y_px, const SampledWavelengths<N>& wavelengths,
               const SampledSpectrum<N>& radiance) noexcept {
        const SensorSample sample = sensor_->sense(wavelengths, radiance);
        splat_light(x_px, y_px, sample, {wavelengths.lambda_nm, radiance.value, wavelengths.pdf});
    }
    void splat(float x_px, float y_px, XYZ value) noexcept { splat_light(x_px, y_px, {value, value.y}, {}); }

    // --- Beside the samples

    /// The values of an auxiliary layer (its place in FilmOptions::aux) that a sample sees; as many as components.
    /// Samples that see nothing leave it out. A value that is not finite is counted in dropped_aux() and kept out.
    void add_aux(int x, int y, std::size_t layer, std::span<const float> values, float weight) noexcept;
    void add_aux_at(float x_px, float y_px, std::size_t layer, std::span<const float> values) noexcept;

    /// The number, in its pixel, of the sample that comes next: MedianOfMeans needs it.
    void set_sample_index(std::uint64_t index) noexcept {
        if (mean_groups_ > 0) group_ = static_cast<int>(index % static_cast<std::uint64_t>(mean_groups_));
    }

    /// Back to no samples, for the next use of the same bounds.
    void clear() noexcept;

    /// Row by row, bounds().width() to a row. Dropped samples are not among a pixel's samples().
    [[nodiscard]] std::span<const Pixel> pixels() const noexcept { return pixels_; }
    /// The further sums of the film's options, pixel by pixel.
    [[nodiscard]] const ChannelSums& channels() const noexcept { return channels_; }
    /// Samples that were added, each counted once, without the dropped ones.
    [[nodiscard]] std::uint64_t sample_count() const noexcept;
    [[nodiscard]] std::uint64_t light_splat_count() const noexcept { return light_splats_; }
    [[nodiscard]] const DroppedSamples& dropped() const noexcept { return dropped_; }
    /// As FilmCounts::faint says; of sums that are not exact, none.
    [[nodiscard]] std::uint64_t faint_count() const noexcept { return faint_samples_; }
    [[nodiscard]] std::uint64_t dropped_aux() const noexcept { return dropped_aux_; }
    [[nodiscard]] const ClampedSamples& clamped() const noexcept { return clamped_; }

  private:
    /// A sample of one pixel, judged by this luminance.
    void accumulate(std::size_t i, int x, int y, XYZ value, float luminance, float weight) noexcept {
        // Products of floats cannot overflow a double: they are finite if, and only if, all four numbers are.
        const bool usual = (luminance > Sums::kFaintLuminance_cdm2 || luminance == 0.0f) &&
                           luminance <= max_luminance_ &&
                           pixels_[i].add(static_cast<double>(value.x), static_cast<double>(value.y),
                                          static_cast<double>(value.z), static_cast<double>(weight));
        if (!usual) [[unlikely]]
            return accumulate_unusual(i, x, y, {value, luminance}, weight);
        carry_in_time(i);
        if (has_more_) [[unlikely]]
            add_more(i, value, weight);
    }
    /// What a sample does beside adding to its pixel, if the film has channels or splats.
    void add_more(std::size_t i, XYZ value, float weight) noexcept;

    [[nodiscard]] std::size_t index(int x, int y) const noexcept {
        assert(bounds_.contains(x, y));
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(y) * width_ + x - first_);
    }

    void accumulate_unusual(std::size_t i, int x, int y, const SensorSample& sample, float weight) noexcept;
    void count_if_faint(float luminance) noexcept {
        if (luminance <= Sums::kFaintLuminance_cdm2) [[unlikely]]
            count_unless_black(luminance);
    }
    void count_unless_black(float luminance) noexcept;
    void add_channels(std::size_t i, XYZ value, float weight) noexcept;
    void add_buckets(std::size_t i, const SensorSample& sample, const SpectralSample& spectral, float weight) noexcept;
    void spread(float x_px, float y_px, const SensorSample& sample, const SpectralSample& spectral) noexcept;
    /// The usual case of it, without memory on the way from the place to the weights: four by four pixels, all of them
    /// inside, and nothing to fill but their sums. Does nothing, and says so, in any other.
    [[nodiscard]] bool spread_quickly(float x_px, float y_px, const SensorSample& sample) noexcept;
    /// Any other. Out of line: its registers are not to be saved in the usual case.
    [[gnu::noinline]] void spread_any(float x_px, float y_px, const SensorSample& sample,
                                      const SpectralSample& spectral) noexcept;
    void splat_light(float x_px, float y_px, const SensorSample& sample, const SpectralSample& spectral) noexcept;
    [[nodiscard]] bool has_place(float x_px, float y_px) const noexcept {
        return all(Float4{x_px, y_px, -x_px, -y_px} >= least_places_);
    }
    [[nodiscard]] bool is_aux_value(std::size_t layer, std::span<const float> values) const noexcept;

    static constexpr bool kCarries = requires(Pixel & pixel) { pixel.carry(); };
    /// Makes room in the sums of a pixel, once in so many samples.
    void carry_in_time(std::size_t i) noexcept {
        if constexpr (kCarries) {
            if (pixels_[i].samples() % kSamplesPerCarry == 0) [[unlikely]]
                pixels_[i].carry();
        }
    }
    /// The same for all pixels, once in so many samples of the tile.
    void carry_all_in_time() noexcept {
        if constexpr (kCarries) {
            if (++since_carry_ % kSamplesPerCarry != 0) [[likely]]
                return;
            for (Pixel& pixel : pixels_) pixel.carry();
        }
    }
    void drop(int x, int y, const SensorSample& sample, float weight) noexcept;

    static constexpr std::uint32_t kSamplesPerCarry = 1u << 23;
    static_assert(kSamplesPerCarry <= ExactTilePixel::kAddsPerCarry);

    PixelBounds places_, bounds_;
    Float4 least_places_;           // of x, y, -x and -y: places_
    std::ptrdiff_t width_, first_;  // pixel (x, y) is y width_ + x - first_
    std::shared_ptr<const FilmSetup> setup_;
    // Of the setup, at hand for every sample.
    const Sensor* sensor_;
    const FilterFootprint* footprint_;                  // null if nothing is splatted
    const FilterFootprint* plain_footprint_ = nullptr;  // and if samples fill more than their pixels' sums
    Float4 least_usual_{}, most_usual_{};               // X, Y, Z and luminance of samples that count, and wholly
    float max_luminance_;
    bool has_channels_, has_buckets_, has_more_;
    int mean_groups_;

    std::vector<Pixel> pixels_;
    ChannelSums channels_;
    int group_ = 0;
    std::uint64_t since_carry_ = 0, spread_samples_ = 0, spread_touches_ = 0, light_splats_ = 0, dropped_aux_ = 0;
    std::uint64_t faint_samples_ = 0;
    DroppedSamples dropped_;
    ClampedSamples clamped_;
    WeightRoom weight_room_;
};

extern template class BasicFilmTile<ExactSums>;
extern template class BasicFilmTile<DoubleSums>;
extern template class BasicFilmTile<FloatSums>;
extern template class BasicFilmTile<KahanFloatSums>;

using FilmTile = BasicFilmTile<ExactSums>;

}  // namespace emulsion
