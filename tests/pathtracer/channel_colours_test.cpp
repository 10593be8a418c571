#include "pathtracer/channel_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "channel_scene.h"
#include "core/random.h"
#include "pathtracer/model_channels.h"

namespace emulsion::testing {
namespace {

constexpr int kMost = 8;

RGB random_colour(Pcg32& random) { return {random.next_float(), random.next_float(), random.next_float()}; }

TEST(ChannelColours, RgbIsMixedAsRgb) {
    const SigmoidTable sigmoids(rgb_space("sRGB"));
    const ChannelColours own(rgb_channels("sRGB"), rgb_space("sRGB"), sigmoids);
    const RGB rgb{0.8f, 0.3f, 1.5f};
    EXPECT_EQ(own.at<3>(rgb).value, (std::array{0.8f, 0.3f, 1.5f}));
    EXPECT_EQ(own.unbounded<3>(rgb), own.at<3>(rgb));

    // In a wider space the same colour is less saturated, and white is white.
    const ChannelColours wide(rgb_channels("Rec2020"), rgb_space("sRGB"), sigmoids);
    const auto red = wide.at<3>({1.0f, 0.0f, 0.0f});
    EXPECT_NEAR(red[0], 0.6274f, 5e-4f);
    EXPECT_NEAR(red[1], 0.0691f, 5e-4f);
    EXPECT_NEAR(red[2], 0.0164f, 5e-4f);
    const auto white = wide.at<3>({1.0f, 1.0f, 1.0f});
    for (const float value : white.value) EXPECT_NEAR(value, 1.0f, 1e-6f);
}

/// Tolerance: 0.01 of the perfect reflector, 0.002 in the mean; what the grid's straight lines lose.
TEST(ChannelColours, FollowTheSpectraOfColours) {
    const SceneSpectra scene{{{catalogue_spectrum("FL11"), 1.0}}, color_checker()};
    const SigmoidTable sigmoids(rgb_space("sRGB"));
    for (const TransportModel& model : {TransportModel{BasisModel{5}}, TransportModel{BasisModel{8}}}) {
        const FixedChannels channels = *channels_of(model, scene);
        const ChannelColours colours(channels, rgb_space("sRGB"), sigmoids);
        Pcg32 random(1);
        double sum = 0.0, largest = 0.0;
        constexpr int kColours = 200;
        for (int i = 0; i < kColours; ++i) {
            const RGB rgb = random_colour(random);
            const auto exact = property_values(channels, sigmoid_of(sigmoids.reflectance(rgb)));
            const auto found = colours.at<kMost>(rgb);
            for (int k = 0; k < static_cast<int>(channels.size()); ++k) {
                const double error = std::abs(static_cast<double>(found[k]) - exact[static_cast<std::size_t>(k)]);
                sum += error / (kColours * static_cast<int>(channels.size()));
                largest = std::max(largest, error);
            }
        }
        EXPECT_LT(sum, 0.002) << to_text(model);
        EXPECT_LT(largest, 0.02) << to_text(model);
    }
}

TEST(ChannelColours, LightsAreWhatTheirSpectraAre) {
    const SceneSpectra scene{{{catalogue_spectrum("FL11"), 1.0}}, color_checker()};
    const Spectrum d65 = catalogue_spectrum("D65");
    const SigmoidTable sigmoids(rgb_space("sRGB"));
    const FixedChannels channels = *channels_of(BasisModel{8}, scene);
    const ChannelColours colours(channels, rgb_space("sRGB"), sigmoids, d65);
    const ChannelValues white = light_values(channels, d65);
    Pcg32 random(2);
    for (int i = 0; i < 50; ++i) {
        const RGB rgb = 10.0f * random_colour(random);
        const ScaledSigmoid colour = sigmoids.unbounded(rgb);
        const ChannelValues exact = light_values(
            channels, product_of(d65, scaled(sigmoid_of(colour.sigmoid), static_cast<double>(colour.scale))));
        const auto found = colours.unbounded<kMost>(rgb);
        const double scale = static_cast<double>(colour.scale) * *std::max_element(white.begin(), white.end());
        for (std::size_t k = 0; k < kMost; ++k)
            EXPECT_NEAR(static_cast<double>(found.value[k]) * white[k] / scale, exact[k] / scale, 0.02);
    }
    EXPECT_EQ(colours.unbounded<kMost>({0.0f, 0.0f, 0.0f}), SampledSpectrum<kMost>(0.0f));
}

TEST(ChannelColours, ColoursOutsideTheRangeAreTheNearest) {
    const FixedChannels channels = *channels_of(BasisModel{4}, {});
    const ChannelColours colours(channels, rgb_space("sRGB"), SigmoidTable(rgb_space("sRGB")));
    EXPECT_EQ(colours.at<4>({-1.0f, 0.5f, 2.0f}), colours.at<4>({0.0f, 0.5f, 1.0f}));
    EXPECT_EQ(colours.at<4>({std::nanf(""), 0.5f, 0.5f}), colours.at<4>({0.0f, 0.5f, 0.5f}));
}

}  // namespace
}  // namespace emulsion::testing
