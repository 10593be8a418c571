#pragma once
// Dithering by random numbers without memory: a number depends on the pixel's place and on the channel alone.

#include <string_view>

#include "display/code_value.h"
#include "display/component_rows.h"
#include "display/encoded_source.h"

namespace emulsion {

/// Rounds up with the probability that the fraction of a code is: the mean is kept, the variance of the error goes from
/// nothing at a code to 1/4 code^2 halfway to the next.
struct WhiteNoise {
    static constexpr std::string_view kName = "white-noise";
    static constexpr std::string_view kHelp = "random thresholds; noise comes and goes between codes";
    bool operator==(const WhiteNoise&) const = default;
};

/// Adds noise two codes wide with a triangular density (TPDF), the sum of two that are a code wide each, and rounds to
/// nearest. The mean is kept and the variance of the error is 1/4 code^2 whatever the value; so a value that is a code
/// exactly doesn't stay one: an eighth of the pixels each get the codes beside it.
/// There are no codes past the ends for noise to reach. Within half a code of an end the value is rounded as WhiteNoise
/// rounds it, which keeps the mean, too, and makes the end exact; the two methods meet half a code from the end, where
/// both give one code or the other with probability 1/2. Where there are but two codes it is white noise everywhere.
/// Source: Lipshitz, Wannamaker & Vanderkooy, "Quantization and Dither: A Theoretical Survey", J. Audio Eng. Soc. 40
/// (1992); the ends are ours.
struct TriangularNoise {
    static constexpr std::string_view kName = "triangular-noise";
    static constexpr std::string_view kHelp = "random, two codes wide: the same noise at every value";
    bool operator==(const TriangularNoise&) const = default;
};

/// As quantize() in display/dither.h.
void quantize(const WhiteNoise& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);
void quantize(const TriangularNoise& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);

}  // namespace emulsion
