#include "spectrum/uplift_sigmoid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "spectrum/cie76_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/colorimetry.h"

namespace emulsion {
namespace {

// A space with its exact fit, and CIE 1976 differences from the colours asked for.
class FitTo {
  public:
    explicit FitTo(const char* name) : space_(reflectance_rgb(rgb_space(name))), fit_(space_) {}

    [[nodiscard]] double difference_of(const RGBd& rgb) const {
        return difference(Cie76Difference{}, lab_of(rgb), lab_of(fit_.reflectance(rgb)));
    }
    [[nodiscard]] Lab lab_of(const RGBd& rgb) const {
        const auto xyz = space_.relative_xyz_from_rgb * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        return lab_from_xyz({xyz[0], xyz[1], xyz[2]}, {1, 1, 1});
    }
    [[nodiscard]] Lab lab_of(const Spectrum& reflectance) const {
        const auto xyz = weighted_sums(space_.xyz_weights, reflectance);
        return lab_from_xyz({xyz[0], xyz[1], xyz[2]}, {1, 1, 1});
    }
    [[nodiscard]] SigmoidSpectrum reflectance(const RGBd& rgb) const { return fit_.reflectance(rgb); }

  private:
    ReflectanceRgb space_;
    SigmoidFit fit_;
};

// A grid of 9^3 colours, corners included.
template <class Visit>
void for_each_grid_colour(const Visit& visit) {
    constexpr int kSteps = 8;
    const auto level = [](int i) { return static_cast<double>(i) / kSteps; };
    for (int r = 0; r <= kSteps; ++r) {
        for (int g = 0; g <= kSteps; ++g) {
            for (int b = 0; b <= kSteps; ++b) visit(RGBd{level(r), level(g), level(b)});
        }
    }
}

TEST(SigmoidFit, ReachesEveryColourOfSrgb) {
    const FitTo srgb("sRGB");
    for_each_grid_colour(
        [&](const RGBd& rgb) { EXPECT_LE(srgb.difference_of(rgb), 1e-6) << rgb.r << ' ' << rgb.g << ' ' << rgb.b; });
}

TEST(SigmoidFit, ReachesTheEdgesAndDarkColoursOfSrgb) {
    const FitTo srgb("sRGB");
    for (const double scale : {1e-9, 1e-6, 1e-4, 1e-3, 0.02, 0.5, 0.98, 0.999, 1.0}) {
        for (const RGBd& hue : {RGBd{1, 0, 0}, RGBd{0, 1, 0}, RGBd{0, 0, 1}, RGBd{1, 1, 0}, RGBd{1, 0, 1},
                                RGBd{0, 1, 1}, RGBd{1, 1, 0.999}, RGBd{0.999, 1, 1}, RGBd{1, 0.5, 0.001}}) {
            const RGBd rgb = scale * hue;
            // The darkest and most saturated ones converge slowly, and may end a little early.
            EXPECT_LE(srgb.difference_of(rgb), scale < 0.02 ? 1e-3 : 1e-6) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        }
    }
}

TEST(SigmoidFit, ReachesWhatIsWithinReachOfWiderSpaces) {
    // No reflectance at all is as saturated as the corners of these spaces. What is within reach must be reached: all
    // colours with some white in them.
    for (const char* name : {"Display_P3", "Rec2020", "ACEScg_AP1", "ROMM_ProPhoto", "ACES2065_1_AP0"}) {
        const FitTo fit(name);
        for_each_grid_colour([&](const RGBd& rgb) {
            const auto [low, high] = std::minmax({rgb.r, rgb.g, rgb.b});
            if (high - low > 0.25 || low < 0.25 || high > 0.75) return;
            EXPECT_LE(fit.difference_of(rgb), 1e-6) << name << ' ' << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        });
    }
}

TEST(SigmoidFit, AgreesWithTheExactIntegral) {
    const RgbSpace& space = rgb_space("sRGB");
    const FitTo srgb("sRGB");
    const PiecewiseLinearSpectrum d65 = illuminant_of(space);
    const XYZd white = xyz_of_reflectance(ConstantSpectrum{1.0}, d65);
    for (const RGBd& rgb : {RGBd{0.8, 0.1, 0.05}, RGBd{0.1, 0.6, 0.2}, RGBd{0.02, 0.1, 0.9}, RGBd{0.3, 0.4, 0.5}}) {
        const Lab integral = lab_from_xyz(xyz_of_reflectance(srgb.reflectance(rgb), d65), white);
        EXPECT_LE(difference(Cie76Difference{}, integral, srgb.lab_of(rgb)), 1e-2)
            << "the fit takes straight lines between whole nanometres, as the renderer does";
    }
}

TEST(SigmoidFit, IsExactForBlackAndWhite) {
    const FitTo srgb("sRGB");
    EXPECT_EQ(eval(srgb.reflectance({0, 0, 0}), 500.0), 0.0);
    EXPECT_EQ(eval(srgb.reflectance({1, 1, 1}), 500.0), 1.0);
}

}  // namespace
}  // namespace emulsion
