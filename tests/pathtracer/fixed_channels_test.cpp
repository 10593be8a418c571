#include "pathtracer/fixed_channels.h"

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "channel_scene.h"
#include "pathtracer/channel_basis.h"
#include "pathtracer/model_channels.h"
#include "spectrum/catalogue.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/colorimetry.h"
#include "spectrum/rgb_space.h"

namespace emulsion::testing {
namespace {

TEST(FixedChannels, LightSeenDirectlyIsExact) {
    // Of lights that the channels were not made for.
    const SceneSpectra scene{{{catalogue_spectrum("D65"), 1.0}}, color_checker()};
    for (const TransportModel& model : fixed_models()) {
        const FixedChannels channels = *channels_of(model, scene);
        for (const char* name : {"D65", "FL11", "HP1", "A"}) {
            const Spectrum light = catalogue_spectrum(name);
            const XYZd expected = xyz_of_radiance(light), found = xyz_of(channels, light_values(channels, light));
            const double scale = expected.y;
            EXPECT_NEAR(found.x / scale, expected.x / scale, 1e-6) << to_text(model) << ' ' << name;
            EXPECT_NEAR(found.y / scale, expected.y / scale, 1e-6) << to_text(model) << ' ' << name;
            EXPECT_NEAR(found.z / scale, expected.z / scale, 1e-6) << to_text(model) << ' ' << name;
        }
    }
}

TEST(FixedChannels, ThePerfectReflectorIsOne) {
    const SceneSpectra scene{{{catalogue_spectrum("FL11"), 1.0}}, color_checker()};
    for (const TransportModel& model : fixed_models()) {
        const FixedChannels channels = *channels_of(model, scene);
        const auto white = property_values(channels, ConstantSpectrum{1.0});
        for (std::size_t k = 0; k < channels.size(); ++k) EXPECT_NEAR(white[k], 1.0, 1e-9);
    }
}

TEST(FixedChannels, RgbIsThatUnderTheWhiteOfTheSpace) {
    const Spectrum d65 = catalogue_spectrum("D65");
    const Matrix3 from_xyz = rgb_from_xyz(rgb_space("sRGB"));
    const FixedChannels channels = rgb_channels("sRGB");
    for (const Spectrum& patch : color_checker()) {
        const XYZd xyz = xyz_of_reflectance(patch, d65);
        const std::array<double, 3> rgb = from_xyz * std::array{xyz.x, xyz.y, xyz.z};
        const auto found = property_values(channels, patch);
        // The space's white is rounded to four decimals, D65's is not.
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], rgb[k], 3e-4);
    }
}

/// One reflection of the light that the channels were made for: exact with prefiltering, and with every basis.
TEST(FixedChannels, OneReflectionOfTheScenesLightIsExact) {
    for (const char* name : {"D65", "FL11", "HP1"}) {
        const Spectrum light = catalogue_spectrum(name);
        const SceneSpectra scene{{{light, 1.0}}, color_checker()};
        const double white = xyz_of_radiance(light).y;
        for (const TransportModel& model : fixed_models()) {
            if (std::holds_alternative<RgbModel>(model)) continue;
            const FixedChannels channels = *channels_of(model, scene);
            for (const Spectrum& patch : color_checker()) {
                const XYZd expected = xyz_of_radiance(product_of(light, patch));
                const XYZd found = xyz_of(channels, reflected(channels, light, {patch}));
                // Paints are straight lines within a nanometre, and light is kept in single precision.
                EXPECT_NEAR(found.x / white, expected.x / white, 5e-6) << to_text(model) << ' ' << name;
                EXPECT_NEAR(found.y / white, expected.y / white, 5e-6) << to_text(model) << ' ' << name;
                EXPECT_NEAR(found.z / white, expected.z / white, 5e-6) << to_text(model) << ' ' << name;
            }
        }
    }
}

/// And that of a monochromatic lamp, of which no three numbers can be told apart.
TEST(FixedChannels, MonochromaticLightIsDimmedRightly) {
    const Spectrum sodium = LineSpectrum{{Line{589.3, 1.0}}, {}};
    const SceneSpectra scene{{{sodium, 1.0}}, color_checker()};
    for (const TransportModel& model : {TransportModel{PrefilteredRgbModel{}}, TransportModel{BasisModel{6}}}) {
        const FixedChannels channels = *channels_of(model, scene);
        for (const Spectrum& patch : color_checker()) {
            const double expected = xyz_of_radiance(sodium).y * eval(patch, 589.3);
            EXPECT_NEAR(xyz_of(channels, reflected(channels, sodium, {patch})).y, expected, 0.01 * expected)
                << to_text(model);
        }
    }
}

/// All pairs of patches, one reflected by the other.
class TwoReflections {
  public:
    explicit TwoReflections(const Spectrum& light) : light_(light), white_(xyz_of_radiance(light)) {
        for (std::size_t i = 0; i < patches_.size(); ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                exact_.push_back(xyz_of_radiance(product_of(light, product_of(patches_[i], patches_[j]))));
            }
        }
    }

    /// Mean CIEDE2000.
    [[nodiscard]] double error_of(const TransportModel& model) const {
        const FixedChannels channels = *channels_of(model, SceneSpectra{{{light_, 1.0}}, patches_});
        std::vector<ChannelValues> reflectance;
        for (const Spectrum& patch : patches_) reflectance.push_back(property_values(channels, patch));
        const ChannelValues direct = light_values(channels, light_);
        double sum = 0.0;
        std::size_t pair = 0;
        for (std::size_t i = 0; i < patches_.size(); ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                ChannelValues values = direct;
                for (std::size_t k = 0; k < values.size(); ++k) {
                    values[k] *= reflectance[i][k] * reflectance[j][k];
                }
                sum += difference(Ciede2000Difference{}, lab_from_xyz(exact_[pair++], white_),
                                  lab_from_xyz(xyz_of(channels, values), white_));
            }
        }
        return sum / static_cast<double>(pair);
    }

  private:
    Spectrum light_;
    XYZd white_;
    std::vector<Spectrum> patches_ = color_checker();
    std::vector<XYZd> exact_;
};

/// Measured, sRGB / prefiltered / basis of 4 / of 8: D65 2.231 / 1.271 / 0.494 / 0.248, FL11 4.633 / 1.066 / 0.912 /
/// 0.145.
TEST(FixedChannels, TwoReflectionsAreBetterWithMoreFunctions) {
    for (const char* name : {"D65", "FL11"}) {
        const TwoReflections reflections(catalogue_spectrum(name));
        const double rgb = reflections.error_of(RgbModel{}), prefiltered = reflections.error_of(PrefilteredRgbModel{});
        const double basis_4 = reflections.error_of(BasisModel{4}), basis_8 = reflections.error_of(BasisModel{8});
        const std::string found =
            fmt::format("{}: {:.3f} / {:.3f} / {:.3f} / {:.3f}", name, rgb, prefiltered, basis_4, basis_8);
        EXPECT_GT(rgb, 1.0) << found;
        EXPECT_LT(prefiltered, 0.6 * rgb) << found;
        EXPECT_LT(basis_4, 0.9 * prefiltered) << found;
        EXPECT_LT(basis_8, 0.6 * basis_4) << found;
        RecordProperty(name, found);
    }
}

TEST(FixedChannels, ScenesWithoutLightsOrColoursAreOfEqualEnergy) {
    const Spectrum equal = ConstantSpectrum{1.0};
    for (const TransportModel& model : fixed_models()) {
        const FixedChannels channels = *channels_of(model, {});
        const XYZd expected = xyz_of_radiance(equal), found = xyz_of(channels, light_values(channels, equal));
        EXPECT_NEAR(found.y / expected.y, 1.0, 1e-6) << to_text(model);
    }
}

}  // namespace
}  // namespace emulsion::testing
