#pragma once
// The compressions of OpenEXR, by the names that they have there.
// Lossless: what is written is read. Lossy: what the pixel type holds already is changed once more. What is lost
// depends on the channel: pxr24 rounds 32-bit floats to 24 bits and leaves halves; b44 and b44a lose of halves and
// leave floats; dwaa and dwab lose of R, G, B and Y (of X and Z nothing), floats becoming halves before that.

#include <array>
#include <string_view>
#include <variant>

#include "core/named_value.h"

namespace emulsion {

struct NoCompression {
    static constexpr std::string_view kName = "none";
    static constexpr std::string_view kHelp = "as it is";
    static constexpr bool kLossy = false;
    bool operator==(const NoCompression&) const = default;
};

struct RleCompression {
    static constexpr std::string_view kName = "rle";
    static constexpr std::string_view kHelp = "run lengths; lossless, quick";
    static constexpr bool kLossy = false;
    bool operator==(const RleCompression&) const = default;
};

struct ZipsCompression {
    static constexpr std::string_view kName = "zips";
    static constexpr std::string_view kHelp = "deflate row by row; lossless";
    static constexpr bool kLossy = false;
    bool operator==(const ZipsCompression&) const = default;
};

struct ZipCompression {
    static constexpr std::string_view kName = "zip";
    static constexpr std::string_view kHelp = "deflate in blocks of 16 rows; lossless";
    static constexpr bool kLossy = false;
    bool operator==(const ZipCompression&) const = default;
};

struct PizCompression {
    static constexpr std::string_view kName = "piz";
    static constexpr std::string_view kHelp = "wavelets; lossless, small files for grainy pictures";
    static constexpr bool kLossy = false;
    bool operator==(const PizCompression&) const = default;
};

struct Pxr24Compression {
    static constexpr std::string_view kName = "pxr24";
    static constexpr std::string_view kHelp = "deflate of 24-bit floats; lossy for 32-bit floats";
    static constexpr bool kLossy = true;
    bool operator==(const Pxr24Compression&) const = default;
};

struct B44Compression {
    static constexpr std::string_view kName = "b44";
    static constexpr std::string_view kHelp = "blocks of 4x4 at a fixed rate; lossy for 16-bit floats";
    static constexpr bool kLossy = true;
    bool operator==(const B44Compression&) const = default;
};

struct B44aCompression {
    static constexpr std::string_view kName = "b44a";
    static constexpr std::string_view kHelp =
        "b44 with smaller blocks where all values are one; lossy for 16-bit floats";
    static constexpr bool kLossy = true;
    bool operator==(const B44aCompression&) const = default;
};

/// Larger levels lose more; 45 is OpenEXR's own default.
inline constexpr double kDwaLevel = 45.0;
inline constexpr ParameterRange kDwaLevels = {0.0, 1e6};

struct DwaaCompression {
    static constexpr std::string_view kName = "dwaa";
    static constexpr std::string_view kHelp = "cosine transform in blocks of 32 rows; lossy";
    static constexpr bool kLossy = true;
    double level = kDwaLevel;
    bool operator==(const DwaaCompression&) const = default;
    static constexpr std::array kParameters = {
        Parameter<DwaaCompression>{"level", &DwaaCompression::level, kDwaLevels, "", "what may be lost"}};
};

struct DwabCompression {
    static constexpr std::string_view kName = "dwab";
    static constexpr std::string_view kHelp = "cosine transform in blocks of 256 rows; lossy";
    static constexpr bool kLossy = true;
    double level = kDwaLevel;
    bool operator==(const DwabCompression&) const = default;
    static constexpr std::array kParameters = {
        Parameter<DwabCompression>{"level", &DwabCompression::level, kDwaLevels, "", "what may be lost"}};
};

/// All of them, in OpenEXR's order. core/named_value.h prints, parses and lists them.
using ExrCompression =
    std::variant<NoCompression, RleCompression, ZipsCompression, ZipCompression, PizCompression, Pxr24Compression,
                 B44Compression, B44aCompression, DwaaCompression, DwabCompression>;

/// Whether it may change values of any channel.
[[nodiscard]] inline bool is_lossy(const ExrCompression& compression) {
    return std::visit([](const auto& chosen) { return chosen.kLossy; }, compression);
}

}  // namespace emulsion
