// Draws the pictures of docs/where-methods-fail.md: stability_pictures FOLDER. scripts/failure-pictures runs it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "caustic.h"
#include "display/display_gamut.h"
#include "display/dither.h"
#include "display/gamut_mapper.h"
#include "display/png_file.h"
#include "noisy_grey.h"
#include "patch_products.h"
#include "spectrum/observer.h"
#include "spectrum/rgb_space.h"
#include "spectrum/transfer_function.h"
#include "step_picture.h"
#include "tonemap/tone_mapper.h"

namespace emulsion::stability {
namespace {

/// Codes of 8 bits, clipped.
CodeRGB code_of(const RGBd& linear) {
    const auto code = [](double value) {
        return static_cast<std::uint16_t>(std::lround(255.0 * encode(SrgbTransfer{}, std::clamp(value, 0.0, 1.0))));
    };
    return {code(linear.r), code(linear.g), code(linear.b)};
}

/// Of XYZ with Y = 1 for white, D65.
RGBd linear_srgb(const XYZd& xyz) {
    const auto [r, g, b] = rgb_from_xyz(rgb_space("sRGB")) * std::array{xyz.x, xyz.y, xyz.z};
    return {r, g, b};
}
CodeRGB code_of(const XYZd& xyz) { return code_of(linear_srgb(xyz)); }

void fill(Image<CodeRGB>& picture, const PixelBounds& bounds, const CodeRGB& color) {
    for (int y = bounds.y0; y < bounds.y1; ++y) {
        for (int x = bounds.x0; x < bounds.x1; ++x) picture(x, y) = color;
    }
}

/// Every pair of two coloured patches, four times as bright as it is. On the left of each field by its spectrum; on the
/// right by RGB above the diagonal, by basis:8 below.
Image<CodeRGB> products() {
    constexpr int kField_px = 26, kPatches = 18;
    const PairProducts rgb = pair_products(RgbModel{}, catalogue_spectrum("D65")),
                       basis = pair_products(BasisModel{8}, catalogue_spectrum("D65"));
    Image<CodeRGB> picture(kField_px * kPatches, kField_px * kPatches);
    fill(picture, {0, 0, picture.width(), picture.height()}, {60, 60, 60});
    std::size_t pair = 0;
    for (int i = 0; i < kPatches; ++i) {
        for (int j = i + 1; j < kPatches; ++j, ++pair) {
            const auto draw = [&](int column, int row, const Product& product) {
                const int x = column * kField_px, y = row * kField_px, middle = x + kField_px / 2;
                fill(picture, {x + 1, y + 1, middle, y + kField_px - 1}, code_of(4.0 * product.spectral));
                fill(picture, {middle, y + 1, x + kField_px - 1, y + kField_px - 1}, code_of(4.0 * product.model));
            };
            draw(j, i, rgb.pair[pair]);
            draw(i, j, basis.pair[pair]);
        }
    }
    return picture;
}

constexpr int kCard_px = 48, kPixel_px = 3;

/// A card of kCard_px pixels a side, each kPixel_px wide, at x.
template <int N>
void draw_card(Image<CodeRGB>& picture, int card, int row, const WavelengthStrategy& strategy, const char* light) {
    const NoisyGrey<N> grey(strategy, catalogue_spectrum(light));
    const XYZd white = grey.white();
    // Each white is shown as the display's.
    const XYZd d65{0.95047, 1.0, 1.08883};
    Pcg32 random(5);
    for (int y = 0; y < kCard_px; ++y) {
        for (int x = 0; x < kCard_px; ++x) {
            const XYZd seen = grey.pixel(16, random);
            const int left = (card * (kCard_px + 2) + x) * kPixel_px, top = (row * (kCard_px + 2) + y) * kPixel_px;
            fill(picture, {left, top, left + kPixel_px, top + kPixel_px},
                 code_of(XYZd{seen.x / white.x * d65.x, seen.y, seen.z / white.z * d65.z}));
        }
    }
}

/// Cards of 16 paths a pixel. Above under D65: one wavelength evenly, one as the eye sees, four, eight. Below under
/// FL11: four evenly, four as the eye sees, four as eye and light have it, eight of these.
Image<CodeRGB> wavelengths() {
    Image<CodeRGB> picture((4 * kCard_px + 6) * kPixel_px, (2 * kCard_px + 2) * kPixel_px);
    draw_card<1>(picture, 0, 0, IndependentUniform{}, "D65");
    draw_card<1>(picture, 1, 0, HeroVisible{}, "D65");
    draw_card<4>(picture, 2, 0, HeroVisible{}, "D65");
    draw_card<8>(picture, 3, 0, HeroVisible{}, "D65");
    draw_card<4>(picture, 0, 1, HeroUniform{}, "FL11");
    draw_card<4>(picture, 1, 1, HeroVisible{}, "FL11");
    draw_card<4>(picture, 2, 1, HeroIlluminant{}, "FL11");
    draw_card<8>(picture, 3, 1, HeroIlluminant{}, "FL11");
    return picture;
}

/// Plain mean, median of five means, clamp at 100; the true mean is middle grey in all.
Image<CodeRGB> fireflies() {
    const std::array<FireflyControl, 3> controls = {NoFireflyControl{}, MedianOfMeans{5}, LuminanceClamp{100.0f}};
    constexpr int kWide_px = 6, kPanel_px = 33 * kWide_px;
    Image<CodeRGB> picture(3 * kPanel_px - kWide_px, 32 * kWide_px);
    for (std::size_t c = 0; c < controls.size(); ++c) {
        const Image<XYZ> mean = caustic_film(controls[c], 256)->xyz_image();
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x) {
                const double grey = 0.18 / kCausticMean * static_cast<double>(mean(x, y).y);
                const int left = static_cast<int>(c) * kPanel_px + x * kWide_px, top = y * kWide_px;
                fill(picture, {left, top, left + kWide_px, top + kWide_px}, code_of(RGBd{grey, grey, grey}));
            }
        }
    }
    return picture;
}

/// Strips of a step of 1 : 1000: over a Gaussian surround, local-adaptation, reinhard-local, durand.
Image<CodeRGB> halos() {
    const Image<XYZ> scene = step();
    std::vector<Image<XYZ>> strips;
    strips.push_back(over_gaussian_surround(scene));
    for (const ToneMapper& mapper :
         {ToneMapper{LocalAdaptation{}}, ToneMapper{ReinhardLocal{}}, ToneMapper{Durand{}}}) {
        strips.push_back(tone_map({mapper}, scene.view(), {0.9505f, 1.0f, 1.089f}, 1).image);
    }
    Image<CodeRGB> picture(512, 4 * 50);
    for (std::size_t s = 0; s < strips.size(); ++s) {
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 512; ++x) {
                const auto grey = static_cast<double>(strips[s](x, y + 8).y);
                picture(x, static_cast<int>(s) * 50 + y) = code_of(RGBd{grey, grey, grey});
            }
        }
    }
    return picture;
}

/// A grey of 0.05 in one bit: Floyd and Steinberg's from row to row, to and fro, and blue noise; dots of 2 x 2.
Image<CodeRGB> worms() {
    constexpr int kSide_px = 120;
    Image<float> grey(256, 256);
    for (float& p : grey.pixels()) p = 0.05f;
    Image<CodeRGB> picture(3 * (2 * kSide_px + 4) - 4, 2 * kSide_px);
    fill(picture, {0, 0, picture.width(), picture.height()}, {128, 128, 128});
    const std::array<Dither, 3> dithers = {FloydSteinberg{}, FloydSteinberg{kSerpentineScan}, BlueNoise{}};
    for (std::size_t d = 0; d < dithers.size(); ++d) {
        const Image<std::uint16_t> codes = quantize(dithers[d], grey.view(), {0, 1}, 1);
        for (int y = 0; y < kSide_px; ++y) {
            for (int x = 0; x < kSide_px; ++x) {
                const auto code = static_cast<std::uint16_t>(255 * codes(x + 100, y + 100));
                const int left = static_cast<int>(d) * (2 * kSide_px + 4) + 2 * x;
                fill(picture, {left, 2 * y, left + 2, 2 * y + 2}, {code, code, code});
            }
        }
    }
    return picture;
}

/// Monochromatic light of 400 to 700 nm at an eighth of white, by gamut mapping: clip, desaturate, oklab. Below, equal
/// energy as paths of one wavelength each make it: on the left with RGB below 0 clipped path by path, on the right as
/// it is.
Image<CodeRGB> negative_rgb() {
    constexpr int kStrip_px = 40;
    const DisplayGamut gamut = display_gamut(SrgbDisplay{});
    const std::array<GamutMapper, 3> mappers = {GamutClip{}, GamutDesaturate{}, GamutOklab{}};
    Image<CodeRGB> picture(600, 4 * (kStrip_px + 2) - 2);
    for (std::size_t m = 0; m < mappers.size(); ++m) {
        for (int x = 0; x < 600; ++x) {
            const XYZd locus = eval(cie_1931_2deg(), 400.0 + 0.5 * x);
            const RGBd rgb = linear_srgb(0.125 / std::max(locus.y, 0.02) * locus);
            const int top = static_cast<int>(m) * (kStrip_px + 2);
            fill(picture, {x, top, x + 1, top + kStrip_px}, code_of(map_gamut(mappers[m], gamut, rgb)));
        }
    }
    RGBd clipped;
    XYZd sum;
    for (int nm = 360; nm <= 830; ++nm) {
        const RGBd rgb = linear_srgb(eval(cie_1931_2deg(), nm));
        clipped = clipped + RGBd{std::max(rgb.r, 0.0), std::max(rgb.g, 0.0), std::max(rgb.b, 0.0)};
        sum = sum + eval(cie_1931_2deg(), nm);
    }
    const int top = 3 * (kStrip_px + 2);
    fill(picture, {0, top, 300, top + kStrip_px}, code_of(0.5 / sum.y * clipped));
    fill(picture, {300, top, 600, top + kStrip_px}, code_of(0.5 / sum.y * sum));
    return picture;
}

void draw_all(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const PngOptions options{.level = 9};
    write_png(folder / "rgb-products.png", products(), options);
    write_png(folder / "wavelengths.png", wavelengths(), options);
    write_png(folder / "fireflies.png", fireflies(), options);
    write_png(folder / "halos.png", halos(), options);
    write_png(folder / "worms.png", worms(), options);
    write_png(folder / "negative-rgb.png", negative_rgb(), options);
}

}  // namespace
}  // namespace emulsion::stability

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: stability_pictures FOLDER\n", stderr);
        return 2;
    }
    try {
        emulsion::stability::draw_all(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
    return 0;
}
