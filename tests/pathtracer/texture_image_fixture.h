#pragma once
// What the tests of picture files share: small ones byte by byte, and what reading them as textures gives.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/color.h"
#include "core/error.h"
#include "pathtracer/texture_image.h"

namespace emulsion {

/// IEC 61966-2-1.
inline double srgb_decoded(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

inline void expect_rgb(const RGB& found, double r, double g, double b, double tolerance = 1e-6) {
    EXPECT_NEAR(found.r, r, tolerance);
    EXPECT_NEAR(found.g, g, tolerance);
    EXPECT_NEAR(found.b, b, tolerance);
}

/// The message of reading these bytes, or "(no error)".
inline std::string error_of(const std::string& name, const std::string& bytes) {
    try {
        static_cast<void>(read_rgb_texels(name, bytes));
    } catch (const IoError& error) {
        return error.what();
    }
    return "(no error)";
}

/// Of 2 x 2 pixels.
inline constexpr std::array kFourColours = {0, 128, 255, 10, 20, 30, 255, 255, 255, 1, 2, 3};

inline std::string bytes_of(const std::vector<int>& values) {
    std::string bytes;
    for (const int value : values) bytes += static_cast<char>(value);
    return bytes;
}

/// 8 x 8 pixels of one colour. A quantisation table of 8s makes the code of a block its first coefficient plus 128; the
/// Huffman tables have symbol 7 as "0" and 0 as "10", and the end of a block as "0".
inline std::string jpeg(int components, const std::string& data) {
    std::string bytes = bytes_of({0xFF, 0xD8, 0xFF, 0xDB, 0, 67, 0}) + std::string(64, '\x08');
    bytes += bytes_of({0xFF, 0xC0, 0, 8 + 3 * components, 8, 0, 8, 0, 8, components});
    for (int i = 1; i <= components; ++i) bytes += bytes_of({i, 0x11, 0});
    bytes += bytes_of({0xFF, 0xC4, 0, 21, 0x00, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0});
    bytes += bytes_of({0xFF, 0xC4, 0, 20, 0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    bytes += bytes_of({0xFF, 0xDA, 0, 6 + 2 * components, components});
    for (int i = 1; i <= components; ++i) bytes += bytes_of({i, 0});
    return bytes + bytes_of({0, 63, 0}) + data + bytes_of({0xFF, 0xD9});
}

/// 128 + 72: "0" 1001000 "0".
inline std::string grey_jpeg() { return jpeg(1, bytes_of({0x48, 0x7F})); }
/// Y = 128: "10" "0"; Cb = 128: the same; Cr = 128 + 64: "0" 1000000 "0".
inline std::string colour_jpeg() { return jpeg(3, bytes_of({0x91, 0x01})); }

}  // namespace emulsion
