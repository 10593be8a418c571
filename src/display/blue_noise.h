#pragma once
// Dithering by blue noise.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/parameters.h"
#include "display/code_value.h"
#include "display/component_rows.h"
#include "display/encoded_source.h"

namespace emulsion {

inline constexpr std::array kBlueNoiseSizes = {ParameterWord{"64", 64}, ParameterWord{"128", 128}};

/// Thresholds of a tile made by the void-and-cluster method (display/void_and_cluster.h) while the library is built.
/// The dots of every grey are spread evenly, without low frequencies and without a regular texture. The channels have
/// the same tile in different places. Each threshold is at the middle of its 1/size^2 of a code: the mean of whole
/// tiles is off by up to half of that.
struct BlueNoise {
    static constexpr std::string_view kName = "blue-noise";
    static constexpr std::string_view kHelp = "thresholds of a void-and-cluster tile: even, no texture";
    int size = 128;  ///< pixels a side of the tile; 64 or 128
    bool operator==(const BlueNoise&) const = default;

    static constexpr std::array kParameters = {Parameter<BlueNoise>{
        "size", &BlueNoise::size, {64.0, 128.0}, "px", "side of the tile; more is finer steps", {}, kBlueNoiseSizes}};
};

/// The ranks of the tile of `size` a side, each of [0, size^2) once, row by row. `size` is 64 or 128.
[[nodiscard]] std::span<const std::uint16_t> blue_noise_ranks(int size) noexcept;

/// As quantize() in display/dither.h.
void quantize(const BlueNoise& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);

}  // namespace emulsion
