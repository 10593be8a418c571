#include "develop/print_preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"
#include "develop/develop.h"
#include "display/display_encoder.h"
#include "spectrum/rgb_space.h"
#include "three_pictures.h"

namespace emulsion {
namespace {

/// A picture that FixedWhite shows as these encoded values of sRGB.
Image<XYZ> constant_scene(const RGBd& encoded, int width, int height) {
    const auto xyz = xyz_from_rgb(rgb_space("sRGB")) * std::array{decode(SrgbTransfer{}, encoded.r),
                                                                  decode(SrgbTransfer{}, encoded.g),
                                                                  decode(SrgbTransfer{}, encoded.b)};
    Image<XYZ> scene(width, height);
    for (XYZ& p : scene.pixels()) {
        p = {static_cast<float>(xyz[0]), static_cast<float>(xyz[1]), static_cast<float>(xyz[2])};
    }
    return scene;
}

Pipeline plain_pipeline(int bits, const Dither& dither) {
    return {.tone_mapper = FixedWhite{.white = 1.0f}, .bits = bits, .dither = dither};
}

/// Mean part of the paper that is under ink: cyan, magenta, yellow, black.
std::array<double, 4> mean_inks(const PrintPlates& plates) {
    std::array<double, 4> sum{};
    for (const CodeRGB& p : plates.cmy.pixels()) {
        sum[0] += p.r, sum[1] += p.g, sum[2] += p.b;
    }
    for (const std::uint16_t code : plates.black.pixels()) sum[3] += code;
    const auto pixels = static_cast<double>(plates.black.pixels().size());
    for (double& ink : sum) ink = 1.0 - (ink / pixels - plates.scale.black) / plates.scale.steps();
    return sum;
}

std::array<double, 3> mean_of(const Image<CodeRGB>& picture) {
    std::array<double, 3> sum{};
    for (const CodeRGB& p : picture.pixels()) sum[0] += p.r, sum[1] += p.g, sum[2] += p.b;
    for (double& component : sum) component /= static_cast<double>(picture.pixels().size());
    return sum;
}

bool is_blank(const PrintPlates& plates, std::uint16_t CodeRGB::*plate) {
    return std::ranges::all_of(plates.cmy.pixels(), [&](const CodeRGB& p) { return p.*plate == plates.scale.white; });
}

const std::vector<BlackGeneration> kGenerations = {GreyReplacement{}, GreyReplacement{0.4}, UnderColorRemoval{},
                                                   UnderColorRemoval{0.7, 0.2}, NoBlackInk{}};

TEST(PrintPreview, OverOneAnotherThePlatesAreTheDevelopedPicture) {
    for (const auto& [name, scene] : three_pictures()) {
        for (const CodeRange& range : {CodeRange{FullRange{}}, CodeRange{NarrowRange{}}}) {
            const Pipeline pipeline{.gamut = GamutOklab{}, .bits = 16, .range = range, .dither = NoDither{}};
            const Image<CodeRGB> developed = develop(scene, pipeline, 0).image;
            for (const BlackGeneration& black : kGenerations) {
                const Image<CodeRGB> printed = composite(print_plates(scene, pipeline, black, 0), 0);
                int largest = 0;
                for (std::size_t i = 0; i < printed.pixels().size(); ++i) {
                    const CodeRGB &a = printed.pixels()[i], &b = developed.pixels()[i];
                    largest = std::max({largest, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
                }
                EXPECT_LE(largest, 2) << name << ' ' << to_text(black);
            }
        }
    }
}

TEST(PrintPreview, WithoutBlackItsPlateIsBlank) {
    const Image<XYZ> scene = three_pictures().front().scene;
    for (const Dither& dither : {Dither{NoDither{}}, Dither{Halftone{}}, Dither{FloydSteinberg{}}}) {
        const PrintPlates plates = print_plates(scene, {.bits = 1, .dither = dither}, NoBlackInk{}, 0);
        EXPECT_TRUE(std::ranges::all_of(plates.black.pixels(), [](std::uint16_t code) { return code == 1; }));
        EXPECT_GT(mean_inks(plates)[0], 0.1);
    }
}

TEST(PrintPreview, GreysAreBlackInkAloneWhereItReplacesThemAll) {
    for (const double grey : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const Image<XYZ> scene = constant_scene({grey, grey, grey}, 40, 30);
        const PrintPlates plates = print_plates(scene, plain_pipeline(8, NoDither{}), GreyReplacement{}, 1);
        for (const auto plate : {&CodeRGB::r, &CodeRGB::g, &CodeRGB::b}) EXPECT_TRUE(is_blank(plates, plate)) << grey;
        EXPECT_NEAR(mean_inks(plates)[3], 1.0 - grey, 0.5 / 255 + 1e-6);
        const std::array<double, 4> inks =
            mean_inks(print_plates(scene, plain_pipeline(8, NoDither{}), NoBlackInk{}, 1));
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(inks[i], 1.0 - grey, 0.5 / 255 + 1e-6) << grey;
    }
}

// A colour with ink on all four plates: black takes 0.5 of the grey component 0.4, and the others what that leaves.
constexpr RGBd kColour = {0.3, 0.45, 0.6};
const BlackGeneration kHalfBlack = GreyReplacement{0.5};
constexpr std::array kInks = {(0.8 - 0.3) / 0.8, (0.8 - 0.45) / 0.8, (0.8 - 0.6) / 0.8, 0.2};

TEST(PrintPreview, HalftonedPlatesHaveTheirInksOnAverage) {
    // Squares of whole cells: 17 and 16 pixels, and 18 of the black plate, whose cells repeat after 6.
    constexpr int kSide = 17 * 16 * 3;
    const Image<XYZ> scene = constant_scene(kColour, kSide, kSide);
    const PrintPlates plates = print_plates(scene, plain_pipeline(1, Halftone{4, kPlateScreens}), kHalfBlack, 0);
    const std::array<double, 4> inks = mean_inks(plates);
    constexpr std::array kCellPixels = {17, 17, 16, 18};
    // The whole number of a cell's pixels nearest to the ink.
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(inks[i], kInks[i], 0.5 / kCellPixels[i] + 1e-6) << i;
}

TEST(PrintPreview, EachPlateHasItsOwnScreen) {
    constexpr int kSide = 72;
    const Image<XYZ> scene = constant_scene(kColour, kSide, kSide);
    const PrintPlates plates = print_plates(scene, plain_pipeline(1, Halftone{4, kPlateScreens}), kHalfBlack, 0);
    // A screen repeats along the sides of its cell: (4, 1), (1, 4), (4, 0) and (3, 3), and not along those of others.
    constexpr std::array kSides = {std::array{4, 1}, std::array{1, 4}, std::array{4, 0}, std::array{3, 3}};
    const auto code = [&](std::size_t plate, int x, int y) -> int {
        const CodeRGB& p = plates.cmy(x, y);
        return std::array<int, 4>{p.r, p.g, p.b, plates.black(x, y)}[plate];
    };
    for (std::size_t plate = 0; plate < 4; ++plate) {
        for (std::size_t screen = 0; screen < 4; ++screen) {
            const auto [a, b] = kSides[screen];
            bool repeats = true;
            for (int y = 0; y + b < kSide; ++y) {
                for (int x = 0; x + a < kSide; ++x) repeats &= code(plate, x, y) == code(plate, x + a, y + b);
            }
            EXPECT_EQ(repeats, plate == screen) << plate << ' ' << screen;
        }
    }
}

// Where dots of black and of the other inks lie as by chance, inks cover one another by the product of their parts.
TEST(PrintPreview, TheMeanOfTheCompositeIsTheColour) {
    constexpr int kSide = 17 * 16 * 3;
    const Image<XYZ> scene = constant_scene(kColour, kSide, kSide);
    const auto error_of = [&](const Dither& dither) {
        const std::array<double, 3> mean =
            mean_of(composite(print_plates(scene, plain_pipeline(1, dither), kHalfBlack, 0), 0));
        return std::max({std::abs(mean[0] - kColour.r), std::abs(mean[1] - kColour.g), std::abs(mean[2] - kColour.b)});
    };
    EXPECT_LT(error_of(WhiteNoise{}), 0.003);
    EXPECT_LT(error_of(BlueNoise{}), 0.003);
    // Error diffusion makes patterns, which meet more or less often than by chance: measured, 0.032.
    EXPECT_LT(error_of(FloydSteinberg{}), 0.04);
    // The inks of halftones are those of whole pixels of a cell; see above.
    EXPECT_LT(error_of(Halftone{4, kPlateScreens}), 0.03);
    // Upright dots lie on one another: less paper is covered.
    EXPECT_GT(error_of(Halftone{4, kUprightScreens}), 0.05);
}

TEST(PrintPreview, TheSheetShowsThePlatesInGrey) {
    const Image<XYZ> scene = constant_scene(kColour, 100, 30);
    const Image<CodeRGB> sheet = plate_sheet(print_plates(scene, plain_pipeline(8, NoDither{}), kHalfBlack, 1));
    for (const double ink : kInks) {
        const auto code = static_cast<std::uint16_t>(std::lround(255.0 * (1.0 - ink)));
        EXPECT_EQ(std::ranges::count(sheet.pixels(), CodeRGB{code, code, code}), 100 * 30) << ink;
    }
    EXPECT_GT(sheet.height(), 2 * 30);
    EXPECT_LT(sheet.width(), 3 * 100);
}

TEST(PrintPreview, IsTheSameForEveryNumberOfThreads) {
    const Image<XYZ> scene = three_pictures().front().scene;
    for (const Dither& dither : {Dither{BlueNoise{}}, Dither{FloydSteinberg{}}}) {
        const PrintPlates one = print_plates(scene, {.dither = dither}, GreyReplacement{}, 1),
                          many = print_plates(scene, {.dither = dither}, GreyReplacement{}, 3);
        EXPECT_EQ(one.cmy, many.cmy);
        EXPECT_EQ(one.black, many.black);
        EXPECT_EQ(composite(one, 1), composite(one, 3));
    }
}

TEST(PrintPreview, RejectsWhatItCannotDo) {
    const Image<XYZ> scene(8, 8);
    EXPECT_THROW((void)print_plates(Image<XYZ>(), {}, GreyReplacement{}, 1), std::invalid_argument);
    EXPECT_THROW((void)print_plates(scene, {.bits = 17}, GreyReplacement{}, 1), std::invalid_argument);
    EXPECT_THROW((void)print_plates(scene, {}, GreyReplacement{}, -1), std::invalid_argument);
    EXPECT_THAT([&] { (void)print_plates(scene, {}, GreyReplacement{1.5}, 1); },
                testing::ThrowsMessage<std::invalid_argument>("black gcr: amount = 1.5: must be in [0, 1]"));
}

}  // namespace
}  // namespace emulsion
