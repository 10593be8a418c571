#include "display/png_color.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "core/named_value.h"
#include "display/icc_profile.h"

namespace emulsion {

namespace {

bool near(const Chromaticity& a, const Chromaticity& b) noexcept {
    constexpr double kTolerance = 5e-6;  // half a step of cHRM
    return std::abs(a.x - b.x) < kTolerance && std::abs(a.y - b.y) < kTolerance;
}

bool same_colors(const RgbSpace& a, const RgbSpace& b) noexcept {
    return near(a.red, b.red) && near(a.green, b.green) && near(a.blue, b.blue) && near(a.white, b.white);
}

// --- Pure powers

std::optional<double> exponent_of(const LinearTransfer& /*transfer*/) noexcept { return 1.0; }
std::optional<double> exponent_of(const GammaTransfer& transfer) noexcept { return transfer.exponent; }
std::optional<double> exponent_of(const AdobeRgbTransfer& /*transfer*/) noexcept {
    return AdobeRgbTransfer::kPower.exponent;
}
std::optional<double> exponent_of(const Bt1886Transfer& transfer) noexcept {
    return transfer.black_cdm2 == 0.0 ? std::optional(Bt1886Transfer::kExponent) : std::nullopt;
}
template <class Transfer>
std::optional<double> exponent_of(const Transfer& /*transfer*/) noexcept {
    return std::nullopt;
}

/// Whether it is fit for cHRM: libpng takes numbers that are no less than 0, also of z = 1 - x - y, and a white that
/// has light; pngcheck finds fault with those above 0.8, which no stimulus of the first standards had.
bool fits_chrm(const Chromaticity& c, double least_y) noexcept {
    constexpr double kHalfStep = 5e-6;
    constexpr double kMost = 0.8;
    return c.x > -kHalfStep && c.y > least_y - kHalfStep && c.x < kMost + kHalfStep && c.y < kMost + kHalfStep &&
           c.x + c.y < 1.0 + kHalfStep;
}
bool fits_chrm(const RgbSpace& space) noexcept {
    return fits_chrm(space.red, 0.0) && fits_chrm(space.green, 0.0) && fits_chrm(space.blue, 0.0) &&
           fits_chrm(space.white, 1e-4);
}

// --- Numbers of ITU-T H.273 (07/2021)

/// Table 2.
std::optional<std::uint8_t> primaries_number(const RgbSpace& space) {
    struct Numbered {
        std::uint8_t number;
        const char* name;
    };
    constexpr std::array<Numbered, 6> kSpaces = {
        {{1, "Rec709"}, {5, "PAL_SECAM"}, {6, "SMPTE_C"}, {9, "Rec2020"}, {11, "DCI_P3"}, {12, "Display_P3"}}};
    for (const auto& [number, name] : kSpaces) {
        if (same_colors(space, rgb_space(name))) return number;
    }
    return std::nullopt;
}

/// Table 3.
std::optional<std::uint8_t> transfer_number(const Bt709Transfer& /*transfer*/) noexcept { return 1; }
std::optional<std::uint8_t> transfer_number(const LinearTransfer& /*transfer*/) noexcept { return 8; }
std::optional<std::uint8_t> transfer_number(const SrgbTransfer& /*transfer*/) noexcept { return 13; }
std::optional<std::uint8_t> transfer_number(const Bt2020Transfer& /*transfer*/) noexcept { return 15; }
std::optional<std::uint8_t> transfer_number(const PqTransfer& /*transfer*/) noexcept { return 16; }
std::optional<std::uint8_t> transfer_number(const HlgTransfer& /*transfer*/) noexcept { return 18; }
std::optional<std::uint8_t> transfer_number(const GammaTransfer& transfer) noexcept {
    if (transfer.exponent == 2.2) return 4;
    if (transfer.exponent == 2.8) return 5;
    return std::nullopt;
}
template <class Transfer>
std::optional<std::uint8_t> transfer_number(const Transfer& /*transfer*/) noexcept {
    return std::nullopt;
}

PngCodePoints code_points(const ColorEncoding& encoding, std::string_view reason) {
    const auto primaries = primaries_number(encoding.space);
    const auto transfer = std::visit([](const auto& chosen) { return transfer_number(chosen); }, encoding.transfer);
    const std::string why = std::string(reason) + ", which a PNG can only say by numbers of H.273";
    if (!primaries) {
        throw std::invalid_argument("PNG with " + why + ": there is none for the primaries and white of " +
                                    encoding.space.name +
                                    "; expected those of Rec709, PAL_SECAM, SMPTE_C, Rec2020, DCI_P3 or Display_P3");
    }
    if (!transfer) {
        throw std::invalid_argument("PNG with " + why + ": there is none for transfer " + to_text(encoding.transfer) +
                                    "; expected srgb, linear, gamma of 2.2 or 2.8, bt709, bt2020, pq or hlg");
    }
    return {*primaries, *transfer, std::holds_alternative<FullRange>(encoding.range)};
}

}  // namespace

PngColor png_color(const ColorEncoding& encoding) {
    if (std::holds_alternative<NarrowRange>(encoding.range)) return code_points(encoding, "range narrow");
    if (std::holds_alternative<PqTransfer>(encoding.transfer)) return code_points(encoding, "transfer pq");
    if (std::holds_alternative<HlgTransfer>(encoding.transfer)) return code_points(encoding, "transfer hlg");
    const bool is_srgb = same_colors(encoding.space, rgb_space("sRGB"));
    if (is_srgb && std::holds_alternative<SrgbTransfer>(encoding.transfer)) return PngSrgb{};
    const auto exponent = std::visit([](const auto& chosen) { return exponent_of(chosen); }, encoding.transfer);
    if (exponent && fits_chrm(encoding.space)) return PngGamma{*exponent, encoding.space};
    return PngProfile{icc_profile(encoding)};
}

}  // namespace emulsion
