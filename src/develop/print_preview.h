#pragma once
// Previews of a print: the picture taken apart into plates of cyan, magenta, yellow and black ink, and the plates put
// over one another again. Not those of any press: see display/separation.h.

#include <cstdint>

#include "core/color.h"
#include "core/image.h"
#include "develop/pipeline.h"
#include "display/code_value.h"
#include "display/separation.h"

namespace emulsion {

/// Codes of what a plate leaves of the paper's white: the scale's white where there is no ink, its black under full
/// ink.
struct PrintPlates {
    Image<CodeRGB> cmy;  ///< cyan in r, magenta in g, yellow in b: what light they take away
    Image<std::uint16_t> black;
    CodeScale scale;
};

/// All stages of the pipeline up to the transfer function; separate() of the encoded picture; then each plate by itself
/// through the pipeline's dithering into codes of its bits and range. Under halftone:screens=plates cyan lies at 15
/// degrees, magenta at 75, yellow at 0 and black at 45; upright dots of all plates lie on one another. Dithers by
/// thresholds have the same for black as for cyan: but for halftones, black is dithered from the bottom up, so that its
/// dots and those of cyan don't know of each other. (Bayer's matrix is one and the same for cyan, magenta and yellow.)
/// Then the composite has the mean of the picture, but for what the patterns of error diffusion have in common: a few
/// hundredths, at one bit.
/// \param scene XYZ, Y in cd/m^2
/// \throws std::invalid_argument if the picture is empty, pipeline or black generation not valid, or threads < 0.
[[nodiscard]] PrintPlates print_plates(const Image<XYZ>& scene, const Pipeline& pipeline, const BlackGeneration& black,
                                       int threads);

/// What the plates look like over one another: for each component the product of what its ink and the black leave, to
/// the nearest code. Of 16 bits without dithering, within 2 codes of the picture that develop() makes: half of one each
/// for the two plates, for the product and for that picture. \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<CodeRGB> composite(const PrintPlates& plates, int threads);

/// Two by two, each in grey with its label: cyan, magenta, yellow, black.
[[nodiscard]] Image<CodeRGB> plate_sheet(const PrintPlates& plates);

}  // namespace emulsion
