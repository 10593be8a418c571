// Samples that decide when a pixel has enough of them.

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "pathtracer/stopping_rule.h"

namespace emulsion {
namespace {

constexpr double kTarget = 6.0;              // CIEDE2000
constexpr std::uint64_t kMostSamples = 256;  // of each pixel
constexpr int kSide_px = 8, kPictures = 8000;

/// One sample in 5000 is 5000, the others are 0: as of paths that meet a lamp by chance. The mean is 1.
float skewed(Pcg32& random) { return random.next_float() < 0.0002f ? 5000.0f : 0.0f; }

/// A sample of every pixel more; returns their sum.
double add_sample(Film& film, Pcg32& random) {
    FilmTile tile = film.make_tile({0, 0, kSide_px, kSide_px});
    double sum = 0.0;
    for (int y = 0; y < kSide_px; ++y) {
        for (int x = 0; x < kSide_px; ++x) {
            const float luminance = skewed(random);
            tile.add(x, y, luminance * XYZ{0.95f, 1.0f, 1.09f}, 1.0f);
            sum += static_cast<double>(luminance);
        }
    }
    film.merge(tile);
    return sum;
}

struct MeanOfPictures {
    double mean = 0.0, standard_error = 0.0;
    double samples = 0.0;  ///< of a pixel, in the mean
};

/// picture(random, sum) makes a picture, gives its samples of a pixel and leaves the sum of all.
template <class Picture>
MeanOfPictures mean_of_pictures(const Picture& picture) {
    double sum = 0.0, squares = 0.0, samples = 0.0;
    for (int i = 0; i < kPictures; ++i) {
        Pcg32 random(static_cast<std::uint64_t>(i));
        double of_picture = 0.0;
        const std::uint64_t count = picture(random, of_picture);
        const double mean = of_picture / (static_cast<double>(count) * kSide_px * kSide_px);
        sum += mean;
        squares += mean * mean;
        samples += static_cast<double>(count);
    }
    const double mean = sum / kPictures;
    return {mean, std::sqrt((squares / kPictures - mean * mean) / kPictures), samples / kPictures};
}

/// Stops by the noise between the even and the odd samples of the picture itself.
std::uint64_t stopped_by_its_own(Pcg32& random, double& sum) {
    // To the rule, a pair of n / 2 samples each is that of a picture of 8 n: its error is sqrt(8) times smaller.
    constexpr std::uint64_t kShare = StoppingRule::kSamplesPerPairSample / 2;
    StoppingRule rule({.width_px = kSide_px, .height_px = kSide_px}, kTarget / std::sqrt(static_cast<double>(kShare)),
                      16);
    std::uint64_t samples = 0;
    while (samples < kMostSamples && rule.stopped().front() == 0) {
        for (int i = 0; i < 16; ++i) sum += add_sample(i % 2 == 0 ? rule.first() : rule.second(), random);
        samples += 16;
        rule.look(kShare * samples, 1);
    }
    return samples;
}

std::uint64_t stopped_by_a_noise_pair(Pcg32& random, double& sum) {
    StoppingRule rule({.width_px = kSide_px, .height_px = kSide_px}, kTarget, 16);
    Pcg32 of_pair(random.next(), 1);
    std::uint64_t samples = 0, pair = 0;
    while (samples < kMostSamples && rule.stopped().front() == 0) {
        for (int i = 0; i < 16 * kSide_px * kSide_px; ++i) sum += static_cast<double>(skewed(random));
        samples += 16;
        for (; pair < StoppingRule::pair_samples(samples); ++pair) {
            (void)add_sample(rule.first(), of_pair);
            (void)add_sample(rule.second(), of_pair);
        }
        rule.look(samples, 1);
    }
    return samples;
}

TEST(Stopping, ByThePicturesOwnSamplesDarkensIt) {
    const MeanOfPictures own = mean_of_pictures(stopped_by_its_own), pair = mean_of_pictures(stopped_by_a_noise_pair);
    // Pixels whose first samples are all black have no noise that could be seen.
    EXPECT_NEAR(own.mean, 0.25, 0.02) << own.standard_error << ' ' << own.samples;
    EXPECT_NEAR(pair.mean, 1.0, 3.0 * pair.standard_error) << pair.samples;
    EXPECT_LT(pair.standard_error, 0.03);
}

}  // namespace
}  // namespace emulsion
