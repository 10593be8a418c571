#include "spectrum/color_system.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<ColorSystem> all_systems() {
    std::vector<ColorSystem> systems;
    for_each_alternative<ColorSystem>([&](const auto& system) { systems.emplace_back(system); });
    return systems;
}

double distance(const XYZd& a, const XYZd& b) {
    const double greatest = std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
    return std::isfinite(a.x + a.y + a.z) ? greatest : std::numeric_limits<double>::infinity();
}

/// Points on the faces of the cube of encoded RGB: where every system has its extremes.
std::vector<RGBd> cube_faces() {
    constexpr int kSteps = 32;
    std::vector<RGBd> points;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
            const double s = static_cast<double>(i) / kSteps, t = static_cast<double>(j) / kSteps;
            for (const double face : {0.0, 1.0}) {
                points.push_back({face, s, t});
                points.push_back({s, face, t});
                points.push_back({s, t, face});
            }
        }
    }
    return points;
}

class EveryColorSystem : public testing::TestWithParam<ColorSystem> {};

INSTANTIATE_TEST_SUITE_P(All, EveryColorSystem, testing::ValuesIn(all_systems()), [](const auto& tested) {
    std::string name = std::visit([](const auto& system) { return std::string(system.kName); }, tested.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST_P(EveryColorSystem, GoesThereAndBackAlsoForNegativeValuesAndAboveOne) {
    const std::vector<ColorContext> contexts = {{},
                                                {rgb_space("Rec2020"), Bt2020Transfer{}, {1.0985, 1.0, 0.3558}},
                                                {rgb_space("ACES2065_1_AP0"), LinearTransfer{}}};
    std::mt19937 generator(20241117);
    std::uniform_real_distribution<double> component(-0.5, 1.5);
    for (const ColorContext& context : contexts) {
        double worst = 0.0;
        for (int i = 0; i < 1000; ++i) {
            const XYZd xyz = {component(generator), component(generator), component(generator)};
            worst = std::max(worst, distance(to_xyz(GetParam(), from_xyz(GetParam(), xyz, context), context), xyz));
        }
        EXPECT_LT(worst, 1e-10) << context.rgb().name;
    }
}

TEST_P(EveryColorSystem, TakesBlackThereAndBack) {
    const ColorContext context;
    const ColorValues black = from_xyz(GetParam(), {}, context);
    EXPECT_LT(distance(to_xyz(GetParam(), black, context), {}), 1e-15);
}

TEST_P(EveryColorSystem, HasTheRangesOfSrgbThatItSays) {
    const ColorContext context;
    const auto components = components_of(GetParam());
    std::vector<double> least(components.size(), 1e300), greatest(components.size(), -1e300);
    for (const RGBd& encoded : cube_faces()) {
        const ColorValues color = from_xyz(GetParam(), context.xyz_from_encoded(encoded), context);
        for (std::size_t i = 0; i < components.size(); ++i) {
            least[i] = std::min(least[i], color.value[i]);
            greatest[i] = std::max(greatest[i], color.value[i]);
        }
    }
    for (std::size_t i = 0; i < components.size(); ++i) {
        const ColorComponent& component = components[i];
        // Rounding outwards to four digits is at most 1/1000; a grid of 1/32 misses up to that of the extremes, and
        // 1/32 of a sixth of a turn of hue.
        const double span = component.max - component.min;
        const double slack = component.unit == "deg" ? 360.0 / 6.0 / 32.0 : 0.002 * span;
        EXPECT_GE(least[i], component.min - 1e-13 * span) << component.name;
        EXPECT_LE(least[i], component.min + slack) << component.name;
        EXPECT_LE(greatest[i], component.max + 1e-13 * span) << component.name;
        EXPECT_GE(greatest[i], component.max - slack) << component.name;
    }
}

TEST_P(EveryColorSystem, KeepsNan) {
    const ColorContext context;
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const XYZd& xyz : {XYZd{kNan, 0.5, 0.5}, XYZd{0.5, kNan, 0.5}, XYZd{0.5, 0.5, kNan}}) {
        const ColorValues color = from_xyz(GetParam(), xyz, context);
        EXPECT_TRUE(
            std::any_of(color.value.begin(), color.value.end(), [](double value) { return std::isnan(value); }));
        const XYZd back = to_xyz(GetParam(), color, context);
        EXPECT_TRUE(std::isnan(back.x) || std::isnan(back.y) || std::isnan(back.z));
    }
}

/// What makes a new system that is in the wrong class fail: its numbers depend on what its white depends on, and on
/// nothing else. XYZ and cones depend on neither, and xyY only for black.
TEST_P(EveryColorSystem, HasTheWhiteThatItsNumbersAreRelativeTo) {
    const XYZd white_a = {1.0985, 1.0, 0.3558}, color = {0.3, 0.4, 0.5};
    const ColorContext d65, a(rgb_space("sRGB"), SrgbTransfer{}, white_a);
    const ColorContext dci(rgb_space("DCI_P3"), SrgbTransfer{}, d65.white());
    const bool follows_rgb = distance(white_of(GetParam(), dci), white_of(GetParam(), d65)) > 1e-3;
    EXPECT_EQ(follows_rgb, from_xyz(GetParam(), color, dci) != from_xyz(GetParam(), color, d65));
    if (from_xyz(GetParam(), color, a) != from_xyz(GetParam(), color, d65)) {
        EXPECT_EQ(white_of(GetParam(), a), white_a);
    }
    EXPECT_NEAR(white_of(GetParam(), a).y, 1.0, 1e-15);
}

/// In the systems that have an achromatic axis the white is on it: Oklab's and IPT's matrices have four decimals or a
/// slightly other D65, the others are exact.
TEST(ColorSystem, WhitesAreGreyInTheirSystems) {
    const ColorContext context(rgb_space("DCI_P3"), SrgbTransfer{}, {1.0985, 1.0, 0.3558});
    const auto chroma = [&](const ColorSystem& system) {
        const ColorValues grey = from_xyz(system, white_of(system, context), context);
        return std::hypot(grey.value[1], grey.value[2]);
    };
    for (const ColorSystem& exact :
         std::vector<ColorSystem>{LabSystem{}, LuvSystem{}, YuvSystem{}, YiqSystem{}, IctcpSystem{}}) {
        EXPECT_LT(chroma(exact), 1e-13) << to_text(exact);
    }
    EXPECT_LT(chroma(OklabSystem{}), 2e-4);
    EXPECT_LT(chroma(IptSystem{}), 2e-4);
    EXPECT_NEAR(from_xyz(NormalisedRgbSystem{}, white_of(NormalisedRgbSystem{}, context), context).value[0], 1.0,
                1e-14);
}

TEST_P(EveryColorSystem, HasAsManyValuesAsComponents) {
    const ColorContext context;
    ColorValues color = from_xyz(GetParam(), {0.3, 0.4, 0.5}, context);
    ASSERT_EQ(static_cast<std::size_t>(color.count), components_of(GetParam()).size());
    for (std::size_t i = static_cast<std::size_t>(color.count); i < color.value.size(); ++i) {
        EXPECT_EQ(color.value[i], 0.0);
    }
    for (const int wrong : {-1, 0, color.count - 1, color.count + 1}) {
        color.count = wrong;
        EXPECT_THAT([&] { (void)to_xyz(GetParam(), color, context); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr("components, expected")));
    }
}

TEST_P(EveryColorSystem, IsFoundByItsNameInAnyCase) {
    const std::string text = to_text(GetParam());
    EXPECT_EQ(parse_named<ColorSystem>(text, "colour system"), GetParam());
    std::string upper = text;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    EXPECT_EQ(parse_named<ColorSystem>(upper, "colour system"), GetParam());
    std::string joined = text;
    std::replace(joined.begin(), joined.end(), '-', '_');
    EXPECT_EQ(parse_named<ColorSystem>(joined, "colour system"), GetParam());
}

TEST_P(EveryColorSystem, SaysWhatItIs) {
    std::set<std::string_view> names;
    for (const ColorComponent& component : components_of(GetParam())) {
        EXPECT_FALSE(component.meaning.empty());
        EXPECT_LT(component.min, component.max);
        EXPECT_TRUE(names.insert(component.name).second) << component.name;
    }
    std::visit([](const auto& system) { EXPECT_FALSE(system.kHelp.empty() || system.kDomain.empty()); }, GetParam());
}

TEST(ColorSystem, IctcpHasTheLuminanceOfItsWhiteAsAParameter) {
    const ColorContext context;
    EXPECT_EQ(parse_named<ColorSystem>("ICtCp:White=0.5", "colour system"), ColorSystem(IctcpSystem{0.5}));
    const ColorSystem dim = parse_named<ColorSystem>("ictcp:white=100", "colour system");
    EXPECT_EQ(dim, ColorSystem(IctcpSystem{100.0}));
    // PQ of 100 cd/m^2 is 0.5081 (ITU-R BT.2100), and of 203 cd/m^2 0.5807 (ITU-R BT.2408).
    EXPECT_NEAR(from_xyz(dim, context.white(), context).value[0], 0.5081, 5e-5);
    EXPECT_NEAR(from_xyz(IctcpSystem{}, context.white(), context).value[0], 0.5807, 5e-5);
    EXPECT_THAT([] { (void)parse_named<ColorSystem>("ictcp:white=0", "colour system"); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("ictcp: white")));
}

TEST(ColorSystem, UnknownNamesListTheNearest) {
    EXPECT_THAT([] { (void)parse_named<ColorSystem>("Labb", "colour system"); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("colour system \"Labb\""), HasSubstr("lab"))));
}

// The two transfer-dependent links are the same for all systems of encoded RGB, so one system stands for all.
TEST(ColorSystem, EncodedRgbGoesThereAndBackWithEveryTransferFunction) {
    for_each_alternative<TransferFunction>([](const auto& transfer) {
        const ColorContext context(rgb_space("sRGB"), transfer);
        std::mt19937 generator(7);
        std::uniform_real_distribution<double> component(-0.5, 1.5);
        for (int i = 0; i < 1000; ++i) {
            const XYZd xyz = {component(generator), component(generator), component(generator)};
            const ColorValues encoded = from_xyz(EncodedRgbSystem{}, xyz, context);
            EXPECT_LT(distance(to_xyz(EncodedRgbSystem{}, encoded, context), xyz), 1e-10) << transfer.kName;
        }
    });
}

TEST(ColorContext, IsSrgbUnlessToldOtherwise) {
    const ColorContext context;
    EXPECT_EQ(context.rgb(), rgb_space("sRGB"));
    EXPECT_EQ(context.white(), xyz_of(Chromaticity{0.3127, 0.329}));
    EXPECT_EQ(to_text(context.transfer()), "srgb");
    // The middle code of 8 bits, by IEC 61966-2-1: ((128/255 + 0.055)/1.055)^2.4.
    const XYZd grey = context.xyz_from_encoded({128.0 / 255.0, 128.0 / 255.0, 128.0 / 255.0});
    EXPECT_NEAR(grey.y, 0.21586050011389926, 1e-15);
}

TEST(ColorContext, AdaptsNothing) {
    const ColorContext context(rgb_space("sRGB"), SrgbTransfer{}, {1.0985, 1.0, 0.3558});
    const XYZd white_of_rgb = context.xyz_from_linear({1.0, 1.0, 1.0});
    EXPECT_NEAR(white_of_rgb.z, 1.0890577508, 1e-10);  // (1 - 0.3127 - 0.329) / 0.329
    EXPECT_LT(from_xyz(LabSystem{}, white_of_rgb, context).value[2], -50.0);
}

TEST(ColorContext, RefusesWhatIsNoWhite) {
    const RgbSpace& rgb = rgb_space("sRGB");
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const XYZd& white : {XYZd{95.0, 100.0, 108.9}, XYZd{0.0, 1.0, 1.0}, XYZd{1.0, 1.0, -0.1}, XYZd{kNan, 1.0, 1.0},
                              XYZd{1.0, kNan, 1.0}, XYZd{1.0, 1.0, kInfinity}}) {
        EXPECT_THAT([&] { ColorContext(rgb, SrgbTransfer{}, white); },
                    ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("white"), HasSubstr("Y = 1"))));
    }
    EXPECT_THAT([&] { ColorContext(rgb, GammaTransfer{0.0}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("transfer gamma: exponent")));
    RgbSpace line = rgb;
    line.green = line.red;
    EXPECT_THROW(ColorContext(line, SrgbTransfer{}), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
