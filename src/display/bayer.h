#pragma once
// Ordered dithering.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "display/code_value.h"
#include "display/component_rows.h"
#include "display/encoded_source.h"

namespace emulsion {

inline constexpr std::array kBayerSizes = {ParameterWord{"2", 2},     ParameterWord{"4", 4},    ParameterWord{"8", 8},
                                           ParameterWord{"16", 16},   ParameterWord{"32", 32},  ParameterWord{"64", 64},
                                           ParameterWord{"128", 128}, ParameterWord{"256", 256}};

/// Thresholds of Bayer's matrix, the same for all channels, so that grey stays grey. Each is at the middle of its
/// 1/size^2 of a code: the mean of whole tiles is off by up to half of that. Source: Bayer, "An Optimum Method for
/// Two-Level Rendition of Continuous-Tone Pictures", Proc. ICC 1973.
struct Bayer {
    static constexpr std::string_view kName = "bayer";
    static constexpr std::string_view kHelp = "ordered: a matrix of thresholds, a regular texture";
    int size = 8;  ///< pixels a side of the matrix; a power of two from 2 to 256
    bool operator==(const Bayer&) const = default;

    static constexpr std::array kParameters = {Parameter<Bayer>{
        "size", &Bayer::size, {2.0, 256.0}, "px", "side of the matrix; more is finer steps", {}, kBayerSizes}};
};

/// The rank of a pixel in a matrix of `size` a side, in [0, size^2): 0 2 / 3 1 for a size of 2.
[[nodiscard]] constexpr int bayer_rank(int x, int y, int size) noexcept {
    int rank = 0;
    for (int bit = 1; bit < size; bit *= 2) {
        const bool right = (x & bit) != 0, below = (y & bit) != 0;
        rank = 4 * rank + (right != below ? 2 : 0) + (below ? 1 : 0);
    }
    return rank;
}

/// As quantize() in display/dither.h.
void quantize(const Bayer& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);

}  // namespace emulsion
