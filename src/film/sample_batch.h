#pragma once
// Samples in batches, as arrays: what a renderer has that traces whole waves of paths, and what the C interface takes.
// A batch goes into a tile whole or not at all: everything is checked before the first sample is added. What comes out
// is, bit for bit, what as many calls of BasicFilmTile::add give.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// What the samples carry: N wavelengths each, those of one sample side by side.
struct BatchRadiance {
    std::size_t wavelengths = 4;        ///< N, in [1, kMostBatchWavelengths]
    std::span<const float> lambda_nm;   ///< in [kMinWavelength_nm, kMaxWavelength_nm]
    std::span<const float> radiance;    ///< W m^-2 sr^-1 nm^-1
    std::span<const float> pdf_per_nm;  ///< density each was drawn with; > 0
};
inline constexpr std::size_t kMostBatchWavelengths = 256;

/// \throws std::invalid_argument unless the arrays have one length and all pixels lie in the bounds; names the first
/// that does not.
void validate(const BatchPixels& pixels, const PixelBounds& bounds);

/// For so many samples. NaN passes: such samples are kept out of the film, and counted.
/// \throws std::invalid_argument naming the number of wavelengths, the length of an array or the first wavelength that
/// is not as it should be.
void validate(const BatchRadiance& radiance, std::size_t samples);

namespace detail {

/// Sizes that samples are added in. Other numbers of wavelengths go as the next larger one.
inline constexpr std::array<int, 9> kBatchWavelengthCounts = {1, 2, 4, 8, 16, 32, 64, 128, 256};
static_assert(kBatchWavelengthCounts.back() == kMostBatchWavelengths);

/// Calls visitor.template operator()<N>() with the smallest N that is enough.
template <class Visitor>
void visit_batch_wavelength_count(std::size_t wavelengths, const Visitor& visitor) {
    const auto visit_if = [&]<int N, int Below>() {
        const bool fits = wavelengths > Below && wavelengths <= N;
        if (fits) visitor.template operator()<N>();
        return fits;
    };
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (visit_if.template operator() < kBatchWavelengthCounts[I],
         I == 0 ? 0 : kBatchWavelengthCounts[I - (I > 0)] > () || ...);
    }
    (std::make_index_sequence<kBatchWavelengthCounts.size()>{});
}

/// Calls add(x, y, weight, i) for every sample.
template <class Add>
void for_each_sample(const BatchPixels& pixels, const Add& add) {
    const std::size_t count = pixels.x_px.size();
    if (pixels.weight.empty()) {
        for (std::size_t i = 0; i < count; ++i) add(pixels.x_px[i], pixels.y_px[i], 1.0f, i);
    } else {
        for (std::size_t i = 0; i < count; ++i) add(pixels.x_px[i], pixels.y_px[i], pixels.weight[i], i);
    }
}

/// The i-th sample, in N >= its number of wavelengths. Wavelengths that it does not have get no radiance; as the sensor
/// divides by N, the others get N / wavelengths of theirs.
template <int N>
void read_sample(const BatchRadiance& from, std::size_t i, SampledWavelengths<N>& wavelengths,
                 SampledSpectrum<N>& radiance) noexcept {
    const std::size_t first = i * from.wavelengths, bytes = from.wavelengths * sizeof(float);
    if (from.wavelengths == N) {  // told apart for the compiler, which copies a known number in registers
        std::memcpy(wavelengths.lambda_nm.data(), &from.lambda_nm[first], N * sizeof(float));
        std::memcpy(wavelengths.pdf.data(), &from.pdf_per_nm[first], N * sizeof(float));
        std::memcpy(radiance.value.data(), &from.radiance[first], N * sizeof(float));
        return;
    }
    wavelengths.lambda_nm.fill(kMinWavelength_nm);
    wavelengths.pdf.fill(1.0f);
    radiance = {};
    std::memcpy(wavelengths.lambda_nm.data(), &from.lambda_nm[first], bytes);
    std::memcpy(wavelengths.pdf.data(), &from.pdf_per_nm[first], bytes);
    std::memcpy(radiance.value.data(), &from.radiance[first], bytes);
    radiance *= static_cast<float>(N) / static_cast<float>(from.wavelengths);
}

}  // namespace detail

/// Adds samples given as radiance. \throws std::invalid_argument as validate() does, with the tile as it was.
template <class Sums>
void add_batch(BasicFilmTile<Sums>& tile, const BatchPixels& pixels, const BatchRadiance& radiance) {
    validate(pixels, tile.bounds());
    validate(radiance, pixels.x_px.size());
    detail::visit_batch_wavelength_count(radiance.wavelengths, [&]<int N>() {
        detail::for_each_sample(pixels, [&](int x, int y, float weight, std::size_t i) {
            SampledWavelengths<N> wavelengths;
            SampledSpectrum<N> values;
            detail::read_sample(radiance, i, wavelengths, values);
            tile.add(x, y, wavelengths, values, weight);
        });
    });
}

/// Adds samples given as XYZ: xyz_of(i) is that of the i-th, in the film's units, as for BasicFilmTile::add. It must
/// not throw. \throws std::invalid_argument as validate() does, with the tile as it was.
template <class Sums, class XyzOf>
requires std::is_invocable_r_v<XYZ, const XyzOf&, std::size_t>
void add_batch(BasicFilmTile<Sums>& tile, const BatchPixels& pixels, const XyzOf& xyz_of) {
    validate(pixels, tile.bounds());
    detail::for_each_sample(pixels,
                            [&](int x, int y, float weight, std::size_t i) { tile.add(x, y, xyz_of(i), weight); });
}

}  // namespace emulsion
