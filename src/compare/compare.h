#pragma once
// Two pictures, and how far they are apart. A is the reference: it says what white is, what relative errors are
// relative to and which tone curve both get. The colour differences are symmetric but for that.

#include <cstdint>
#include <optional>
#include <utility>

#include "compare/compared_picture.h"
#include "compare/difference_statistics.h"
#include "compare/squared_difference.h"
#include "core/image.h"
#include "develop/pipeline.h"
#include "spectrum/chromaticity.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion {

struct CompareOptions {
    std::optional<Chromaticity> white = std::nullopt;  ///< of CIELAB; unset: default_white() of the pictures' observer
    std::optional<double> white_luminance_cdm2 =
        std::nullopt;        ///< Yw, in [1e-30, 1e30]; unset: A's log-average is middle grey
    Pipeline pipeline = {};  ///< of the encoded pictures that the PSNR is of
    int threads = 0;         ///< >= 0; 0: one per hardware thread; no result depends on it
};

/// Where the luminance of white comes from.
enum class WhiteLuminanceSource {
    given,
    log_average_of_a,
    log_average_of_b,  ///< A has no pixel of positive luminance
    none               ///< nor has B: 1 cd/m^2
};

/// Pixels that a rule of spectrum/viewing_conditions.h has changed, or that have no colour at all.
struct PixelRuleCounts {
    std::int64_t not_finite = 0;   ///< a component is NaN or infinite: left out of everything, in A and in B
    std::int64_t negative = 0;     ///< finite, with a component below 0, which counts as 0 for colour differences
    std::int64_t above_white = 0;  ///< finite, brighter than white: brought to it for CIEDE2000
    bool operator==(const PixelRuleCounts&) const = default;
};

struct Comparison {
    ViewingConditions viewing;
    WhiteLuminanceSource white_source = WhiteLuminanceSource::given;
    PixelBounds window;  ///< of the frame: the pixels that both have
    PixelRuleCounts a, b;
    std::int64_t left_out = 0;                             ///< pixels that are not finite in A or B
    std::optional<std::pair<int, int>> first_left_out_px;  ///< in reading order; in the frame
    DifferenceStatistics ciede2000, itp;                   ///< places are in the frame
    SquaredDifference squared;
    double psnr_db = 0.0;            ///< encoded_psnr_db()
    Image<double> ciede2000_pixels;  ///< of the window; NaN for those left out
};

/// CIEDE2000 and dE_ITP (BT.2124) by the rule of spectrum/viewing_conditions.h, of X, Y and Z as they are, whichever
/// observer they are of.
/// \throws std::invalid_argument if the frames differ in size, no pixel is in both windows or none is finite in both,
/// the observers differ, or an option is out of its range.
[[nodiscard]] Comparison compare(const ComparedPicture& a, const ComparedPicture& b, const CompareOptions& options);

}  // namespace emulsion
