#pragma once
// Halftoning by dots that grow.

#include <array>
#include <string_view>
#include <vector>

#include "core/parameters.h"
#include "display/code_value.h"
#include "display/component_rows.h"
#include "display/encoded_source.h"

namespace emulsion {

/// How the dots of the channels lie. Upright: all the same, in rows and columns. Plates: each channel turned by an
/// angle of its own, as the plates of a print are, so that they make rosettes: red, green and blue, which cyan, magenta
/// and yellow take from white, at 15, 75 and 0 degrees, a single channel (black) at 45.
inline constexpr int kUprightScreens = 0, kPlateScreens = 1;
inline constexpr std::array kHalftoneScreens = {ParameterWord{"upright", kUprightScreens},
                                                ParameterWord{"plates", kPlateScreens}};

/// Clustered-dot ordered dithering: thresholds of a cell that fill it from one place. Upright cells of 2, 3 and 4
/// pixels are the classical ones with 5, 10 and 17 levels; others fill by distance from their middle. Turned cells have
/// whole pixels, too: their sides are (a, b) and (-b, a) with a and b nearest to size times cosine and sine of the
/// angle, so that they have a^2 + b^2 pixels. Of 4: (4, 1), which is 14 degrees, 17 pixels; (1, 4); (4, 0); and (3, 3),
/// 18 pixels. The smaller the cell the worse the angle: of 2, 15 degrees become 27. Thresholds are at the middle of
/// their part of a code: the mean of whole cells is off by up to half of a code by their number. Sources: Foley, van
/// Dam, Feiner & Hughes, "Computer Graphics: Principles and Practice" (1990), 13.1.2; Holladay, "An Optimum Algorithm
/// for Halftone Generation for Displays and Hard Copies", Proc. SID 21 (1980).
struct Halftone {
    static constexpr std::string_view kName = "halftone";
    static constexpr std::string_view kHelp = "dots that grow, as in print; size^2 + 1 levels of one bit";
    int size = 4;                   ///< pixels a side of a cell; 2 to 16
    int screens = kUprightScreens;  ///< one of kHalftoneScreens
    bool operator==(const Halftone&) const = default;

    static constexpr std::array kParameters = {
        Parameter<Halftone>{"size", &Halftone::size, {2.0, 16.0}, "px", "side of a cell"},
        Parameter<Halftone>{"screens",
                            &Halftone::screens,
                            {kUprightScreens, kPlateScreens},
                            "",
                            "how the channels' dots lie",
                            {},
                            kHalftoneScreens}};
};

/// The cells of one channel: sides of (a, b) and (-b, a), in pixels.
struct HalftoneCell {
    int a, b;
    [[nodiscard]] constexpr int pixels() const noexcept { return a * a + b * b; }
    bool operator==(const HalftoneCell&) const = default;
};

/// The cells of a channel of so many.
[[nodiscard]] HalftoneCell halftone_cell(const Halftone& dither, int channel, int channels);

/// Ranks of the pixels of a square, row by row, that repeats to all of the screen; every rank from 0 to one less than
/// the cell's pixels as often as any other. The side of the square is the cell's pixels. 0 is the last to become white.
[[nodiscard]] std::vector<int> halftone_ranks(const HalftoneCell& cell);

/// As quantize() in display/dither.h.
void quantize(const Halftone& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);

}  // namespace emulsion
