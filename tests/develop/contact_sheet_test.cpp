#include "develop/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

/// How many of the sheet's pixels are of the colour.
std::ptrdiff_t count_of(const Image<CodeRGB>& sheet, const CodeRGB& color) {
    return std::count(sheet.pixels().begin(), sheet.pixels().end(), color);
}

TEST(ContactSheet, HasATileForEveryOperator) {
    // Black pictures: tiles are black, and nothing else of the sheet is.
    for (const auto& [width, height] : {std::pair{64, 32}, {7, 500}, {1, 1}}) {
        const Image<CodeRGB> sheet = contact_sheet(Image<XYZ>(width, height), {}, operator_tiles(), 32, 0);
        const double shrink = std::min(1.0, 32.0 / std::max(width, height));
        const auto tile = std::max(1L, std::lround(shrink * width)) * std::max(1L, std::lround(shrink * height));
        EXPECT_EQ(count_of(sheet, {}), tile * static_cast<long>(std::variant_size_v<ToneMapper>)) << width;
    }
}

TEST(ContactSheet, TilesAreAdaptedToWhatIsGiven) {
    const Adaptation spot = SpotAdaptation{.x = 0.0f, .radius = 0.1f};
    const std::vector<ContactTile> own = operator_tiles(), given = operator_tiles(spot);
    ASSERT_EQ(given.size(), own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
        EXPECT_EQ(given[i].label, own[i].label);
        EXPECT_EQ(given[i].mapping, (ToneMapping{own[i].mapping.mapper, spot})) << own[i].label;
        EXPECT_EQ(own[i].mapping.adaptation, std::nullopt) << own[i].label;
    }
}

TEST(ContactSheet, AveragesWhatIsShown) {
    // Half of every stretch is far past white, half is black: a flat tile, that max-to-white makes linear grey.
    Image<XYZ> scene(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; x += 2) scene(x, y) = {0.9505f, 1.0f, 1.089f};
    }
    const Pipeline pipeline{.dither = NoDither{}};
    const Image<CodeRGB> sheet = contact_sheet(scene, pipeline, operator_tiles(), 32, 1);
    // sRGB of 0.5 is 187.5.
    EXPECT_GE(count_of(sheet, {188, 188, 188}) + count_of(sheet, {187, 187, 187}), 32 * 32);
}

TEST(ContactSheet, StripOfExposuresStandsInOneRow) {
    // Grey of 2 cd/m^2 under whites of 40, 4 and 0.4.
    Image<XYZ> scene(64, 64);
    for (XYZ& pixel : scene.pixels()) pixel = {2.0f * 0.9505f, 2.0f, 2.0f * 1.089f};
    const std::vector<ContactTile> tiles = exposure_tiles(4.0);
    ASSERT_EQ(tiles.size(), 3u);
    EXPECT_EQ(tiles[0].label, "fixed:white=40");
    EXPECT_EQ(tiles[2].label, "fixed:white=0.4");
    const Image<CodeRGB> sheet = contact_sheet(scene, {.dither = NoDither{}}, tiles, 32, 1);
    EXPECT_LT(sheet.height(), 3 * 32);  // a second row would need 3 times 32 and two labels
    // sRGB of 0.05 is 63.2, of 0.5 187.5.
    EXPECT_EQ(count_of(sheet, {63, 63, 63}), 32 * 32);
    EXPECT_EQ(count_of(sheet, {188, 188, 188}) + count_of(sheet, {187, 187, 187}), 32 * 32);
    EXPECT_EQ(count_of(sheet, {255, 255, 255}), 32 * 32);
}

// Codes of PQ are luminances up to 10000 cd/m^2: the sheet's own greys are of the display's white, too.
TEST(ContactSheet, NoneOfItIsBrighterThanTheDisplay) {
    Image<XYZ> scene(32, 32);
    for (XYZ& pixel : scene.pixels()) pixel = {0.9505f, 1.0f, 1.089f};
    const Pipeline pipeline{.display = Hdr10Display{}, .bits = 10, .dither = NoDither{}};
    const Image<CodeRGB> sheet = contact_sheet(scene, pipeline, exposure_tiles(1.0), 32, 1);
    const double peak = encode(PqTransfer{}, 0.1),
                 ink = encode(PqTransfer{}, 0.1 * decode(SrgbTransfer{}, 220.0 / 255));
    std::uint16_t brightest = 0;
    for (const CodeRGB& pixel : sheet.pixels()) brightest = std::max({brightest, pixel.r, pixel.g, pixel.b});
    EXPECT_EQ(brightest, std::lround(1023.0 * peak));
    const auto label = static_cast<std::uint16_t>(std::lround(1023.0 * ink));
    EXPECT_GT(count_of(sheet, {label, label, label}), 50);
}

TEST(ContactSheet, RejectsWhatItCannotDraw) {
    const Image<XYZ> scene(8, 8);
    EXPECT_THROW((void)contact_sheet(scene, {}, operator_tiles(), 15, 1), std::invalid_argument);
    EXPECT_THROW((void)contact_sheet(scene, {}, operator_tiles(), 4097, 1), std::invalid_argument);
    EXPECT_THROW((void)contact_sheet(Image<XYZ>(), {}, operator_tiles(), 32, 1), std::invalid_argument);
    EXPECT_THROW((void)contact_sheet(scene, {}, operator_tiles(), 32, -1), std::invalid_argument);
    EXPECT_THROW((void)contact_sheet(scene, {}, {}, 32, 1), std::invalid_argument);
    EXPECT_THROW((void)exposure_tiles(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
