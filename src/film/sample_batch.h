#pragma once
// Samples in batches, as arrays: what a renderer has that traces whole waves of paths, and what the C interface takes.
// A batch goes into a tile whole or not at all: everything is checked before the first sample is added. What comes out
// is, bit for bit, what as many calls of BasicFilmTile::add give. (A number of wavelengths that is no power of two goes
// as the next one, with wavelengths that carry nothing and densities that are as much smaller.)

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "core/color.h"
#include "core/image.h"
#include "film/film_tile.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

/// Where the samples of a batch belong; arrays of one length.
struct BatchPixels {
    std::span<const std::int32_t> x_px, y_px;  ///< in the film's coordinates, inside the tile's bounds
    std::span<const float> weight;             ///< signed, as for BasicFilmTile::add; empty: 1 each
};

/// Where samples are that are spread by the film's filter, in pixels: pixel (x, y) covers [x, x + 1) x [y, y + 1).
struct BatchPlaces {
    std::span<const float> x_px, y_px;  ///< finite; of one length
};

/// What the samples carry: N wavelengths each, those of one sample side by side.
struct BatchRadiance {
    std::size_t wavelengths = 4;        ///< N, in [1, kMostBatchWavelengths]
    std::span<const float> lambda_nm;   ///< finite
    std::span<const float> radiance;    ///< W m^-2 sr^-1 nm^-1
    std::span<const float> pdf_per_nm;  ///< density each was drawn with; 0: given up, carries nothing
};
inline constexpr std::size_t kMostBatchWavelengths = 256;

/// \throws std::invalid_argument unless the arrays have one length and all pixels lie in the bounds; names the first
/// that does not.
void validate(const BatchPixels& pixels, const PixelBounds& bounds);

/// \throws std::invalid_argument unless the arrays have one length and all places are finite and, if there are bounds,
/// inside them, the edges included; names the first that is not.
void validate(const BatchPlaces& places, const std::optional<PixelBounds>& bounds);

/// For so many samples.
/// \throws std::invalid_argument naming the number of wavelengths, or an array that has another length.
void validate(const BatchRadiance& radiance, std::size_t samples);

namespace detail {

/// Sizes that samples are added in. Other numbers of wavelengths go as the next larger one.
inline constexpr std::array<int, 9> kBatchWavelengthCounts = {1, 2, 4, 8, 16, 32, 64, 128, 256};
static_assert(kBatchWavelengthCounts.back() == kMostBatchWavelengths);

/// Calls visitor.template operator()<N>() with the smallest N that is enough.
template <std::size_t I = 0, class Visitor>
void visit_batch_wavelength_count(std::size_t wavelengths, const Visitor& visitor) {
    constexpr int kCount = kBatchWavelengthCounts[I];
    if constexpr (I + 1 < kBatchWavelengthCounts.size()) {
        if (wavelengths > kCount) return visit_batch_wavelength_count<I + 1>(wavelengths, visitor);
    }
    visitor.template operator()<kCount>();
}

/// Calls add(i, x, y, weight) for every sample. Pointers of its own: the compiler must take it that a sum which is
/// written may be one of the spans' pointers.
template <class Add>
void for_each_sample(const BatchPixels& pixels, const Add& add) {
    const std::size_t count = pixels.x_px.size();
    const std::int32_t *const x = pixels.x_px.data(), *const y = pixels.y_px.data();
    const float* const weight = pixels.weight.data();
    if (pixels.weight.empty()) {
        for (std::size_t i = 0; i < count; ++i) add(i, x[i], y[i], 1.0f);
    } else {
        for (std::size_t i = 0; i < count; ++i) add(i, x[i], y[i], weight[i]);
    }
}

/// Calls add(i, x_px, y_px) for every sample.
template <class Add>
void for_each_sample(const BatchPlaces& places, const Add& add) {
    for (std::size_t i = 0; i < places.x_px.size(); ++i) add(i, places.x_px[i], places.y_px[i]);
}

template <int N>
struct BatchSpectrum {
    SampledWavelengths<N> wavelengths;
    SampledSpectrum<N> radiance;
};

/// The i-th sample, of N wavelengths.
template <int N>
BatchSpectrum<N> read_sample(const BatchRadiance& from, std::size_t i) noexcept {
    BatchSpectrum<N> sample;
    std::memcpy(sample.wavelengths.lambda_nm.data(), &from.lambda_nm[i * N], N * sizeof(float));
    std::memcpy(sample.wavelengths.pdf.data(), &from.pdf_per_nm[i * N], N * sizeof(float));
    std::memcpy(sample.radiance.value.data(), &from.radiance[i * N], N * sizeof(float));
    return sample;
}

/// The i-th sample, of fewer than N wavelengths, as one of N: the sensor divides by N, and by densities that are as
/// much smaller. A density of 0 says of the others that they are not there.
template <int N>
BatchSpectrum<N> read_shorter_sample(const BatchRadiance& from, std::size_t i) noexcept {
    BatchSpectrum<N> sample;
    const std::size_t count = from.wavelengths, first = i * count;
    std::copy_n(&from.lambda_nm[first], count, sample.wavelengths.lambda_nm.begin());
    std::copy_n(&from.radiance[first], count, sample.radiance.value.begin());
    const float share = static_cast<float>(count) / static_cast<float>(N);
    std::transform(&from.pdf_per_nm[first], &from.pdf_per_nm[first] + count, sample.wavelengths.pdf.begin(),
                   [share](float pdf) { return share * pdf; });
    return sample;
}

/// Calls add(wavelengths, radiance, where...) for every i and where... that for_each calls its argument with: spectra
/// of a number of wavelengths that the compiler knows.
template <class ForEach, class Add>
void for_each_spectrum(const BatchRadiance& from, const ForEach& for_each, const Add& add) {
    visit_batch_wavelength_count(from.wavelengths, [&]<int N>() {
        const auto visit_with = [&](const auto& read) {
            for_each([read, add, from](std::size_t i, auto... where) {
                const BatchSpectrum<N> sample = read(from, i);
                add(sample.wavelengths, sample.radiance, where...);
            });
        };
        if (from.wavelengths == N) {
            visit_with([](const auto&... sample) { return read_sample<N>(sample...); });
        } else {
            visit_with([](const auto&... sample) { return read_shorter_sample<N>(sample...); });
        }
    });
}

}  // namespace detail

/// A function that gives the XYZ of the i-th sample, in the film's units, as BasicFilmTile takes it; it must not throw.
template <class F>
concept BatchXyz = std::is_nothrow_invocable_r_v<XYZ, const F&, std::size_t>;

// All of these throw std::invalid_argument as validate() does, with the tile as it was.

/// As BasicFilmTile::add.
template <class Sums>
void add_batch(BasicFilmTile<Sums>& tile, const BatchPixels& pixels, const BatchRadiance& radiance) {
    validate(pixels, tile.bounds());
    validate(radiance, pixels.x_px.size());
    detail::for_each_spectrum(
        radiance, [&](const auto& visit) { detail::for_each_sample(pixels, visit); },
        [&tile](const auto& wavelengths, const auto& values, int x, int y, float weight) {
            tile.add(x, y, wavelengths, values, weight);
        });
}
template <class Sums, BatchXyz XyzOf>
void add_batch(BasicFilmTile<Sums>& tile, const BatchPixels& pixels, const XyzOf& xyz_of) {
    validate(pixels, tile.bounds());
    detail::for_each_sample(pixels,
                            [&](std::size_t i, int x, int y, float weight) { tile.add(x, y, xyz_of(i), weight); });
}

/// As BasicFilmTile::add_at.
template <class Sums>
void add_batch_at(BasicFilmTile<Sums>& tile, const BatchPlaces& places, const BatchRadiance& radiance) {
    validate(places, tile.places());
    validate(radiance, places.x_px.size());
    detail::for_each_spectrum(
        radiance, [&](const auto& visit) { detail::for_each_sample(places, visit); },
        [&tile](const auto& wavelengths, const auto& values, float x_px, float y_px) {
            tile.add_at(x_px, y_px, wavelengths, values);
        });
}
template <class Sums, BatchXyz XyzOf>
void add_batch_at(BasicFilmTile<Sums>& tile, const BatchPlaces& places, const XyzOf& xyz_of) {
    validate(places, tile.places());
    detail::for_each_sample(places, [&](std::size_t i, float x_px, float y_px) { tile.add_at(x_px, y_px, xyz_of(i)); });
}

/// As BasicFilmTile::splat.
template <class Sums>
void splat_batch(BasicFilmTile<Sums>& tile, const BatchPlaces& places, const BatchRadiance& radiance) {
    validate(places, std::nullopt);
    validate(radiance, places.x_px.size());
    detail::for_each_spectrum(
        radiance, [&](const auto& visit) { detail::for_each_sample(places, visit); },
        [&tile](const auto& wavelengths, const auto& values, float x_px, float y_px) {
            tile.splat(x_px, y_px, wavelengths, values);
        });
}
template <class Sums, BatchXyz XyzOf>
void splat_batch(BasicFilmTile<Sums>& tile, const BatchPlaces& places, const XyzOf& xyz_of) {
    validate(places, std::nullopt);
    detail::for_each_sample(places, [&](std::size_t i, float x_px, float y_px) { tile.splat(x_px, y_px, xyz_of(i)); });
}

}  // namespace emulsion
