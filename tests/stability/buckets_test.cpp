// Buckets of wavelengths: the number of wavelengths that a bucket gets has the period of their rotation.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "spectrum/catalogue.h"
#include "spectrum/integral.h"

namespace emulsion {
namespace {

constexpr SpectralBuckets kBuckets{16, 380.0, 780.0};

/// Wavelengths of paths whose numbers are stratified: path i of `paths` has its u in [i, i + 1) / paths.
std::vector<SampledWavelengths<4>> stratified_paths(int paths) {
    std::vector<SampledWavelengths<4>> all;
    Pcg32 random(4);
    for (int i = 0; i < paths; ++i) {
        const float u = (static_cast<float>(i) + random.next_float()) / static_cast<float>(paths);
        SampledWavelengths<4>& path = all.emplace_back();
        for (std::size_t k = 0; k < 4; ++k) {
            const float rotated = u + 0.25f * static_cast<float>(k);
            path.lambda_nm[k] = 380.0f + 400.0f * (rotated - std::floor(rotated));
            path.pdf[k] = 1.0f / 400.0f;
        }
    }
    return all;
}

// Every path has one wavelength in each quarter of the range, at the same place of it. So buckets a quarter apart have
// the same number of them, and what one has too many, all four have: noise with the period of the rotation.
TEST(SpectralBuckets, OfPlainEstimatesHaveTheRotationsPeriod) {
    const std::vector<SampledWavelengths<4>> paths = stratified_paths(22);
    std::array<double, 16> plain{};
    Film film({.width_px = 1, .height_px = 1, .spectrum = kBuckets});
    FilmTile tile = film.make_tile(film.bounds());
    for (const SampledWavelengths<4>& path : paths) {
        for (std::size_t k = 0; k < 4; ++k) {
            // Radiance 1 over N, the density and the bucket's width, in the mean over paths.
            const auto bucket = static_cast<std::size_t>((path.lambda_nm[k] - 380.0f) / 25.0f);
            plain[bucket] += 1.0 / (4.0 * static_cast<double>(path.pdf[k]) * 25.0 * static_cast<double>(paths.size()));
        }
        tile.add(0, 0, path, SampledSpectrum<4>(1.0f), 1.0f);
    }
    film.merge(tile);
    const auto [least, largest] = std::minmax_element(plain.begin(), plain.end());
    EXPECT_NEAR(*least, 0.727, 0.005);
    EXPECT_NEAR(*largest, 1.091, 0.005);
    for (std::size_t b = 0; b < 12; ++b) EXPECT_NEAR(plain[b], plain[b + 4], 1e-6) << b;

    film.for_each_pixel([&film](std::size_t, const PixelSums& sums) {
        for (int b = 0; b < 16; ++b) EXPECT_NEAR(*bucket_radiance_of(sums, film.setup(), b, 0), 1.0, 1e-6) << b;
    });
}

/// The largest relative error of a bucket's radiance, and of that by counts alone.
struct BucketErrors {
    double plain = 0.0, ours = 0.0;
};
BucketErrors bucket_errors_of_d65(int path_count) {
    const Spectrum light = catalogue_spectrum("D65");
    std::array<double, 16> plain{};
    Film film({.width_px = 1, .height_px = 1, .spectrum = kBuckets});
    FilmTile tile = film.make_tile(film.bounds());
    for (const SampledWavelengths<4>& path : stratified_paths(path_count)) {
        SampledSpectrum<4> radiance;
        for (std::size_t k = 0; k < 4; ++k) {
            const double value = eval(light, static_cast<double>(path.lambda_nm[k]));
            radiance.value[k] = static_cast<float>(value);
            plain[static_cast<std::size_t>((path.lambda_nm[k] - 380.0f) / 25.0f)] += 4.0 * value / path_count;
        }
        tile.add(0, 0, path, radiance, 1.0f);
    }
    film.merge(tile);
    BucketErrors worst;
    film.for_each_pixel([&](std::size_t, const PixelSums& sums) {
        for (int b = 0; b < 16; ++b) {
            const double from_nm = 380.0 + 25.0 * b, mean = integral(light, from_nm, from_nm + 25.0) / 25.0;
            worst.plain = std::max(worst.plain, std::abs(plain[static_cast<std::size_t>(b)] / mean - 1.0));
            worst.ours = std::max(worst.ours, std::abs(*bucket_radiance_of(sums, film.setup(), b, 0) / mean - 1.0));
        }
    });
    return worst;
}

// Of a spectrum that is not constant there remains where in a bucket its wavelengths lie, with the same period.
TEST(SpectralBuckets, OfRatiosKeepWhereInABucketWavelengthsLie) {
    const BucketErrors few = bucket_errors_of_d65(22), many = bucket_errors_of_d65(1022);
    EXPECT_NEAR(few.plain, 0.295, 0.001);
    EXPECT_NEAR(few.ours, 0.088, 0.001);
    EXPECT_NEAR(many.plain, 0.0023, 0.0001);
    EXPECT_NEAR(many.ours, 0.0004, 0.0001);
}

}  // namespace
}  // namespace emulsion
