#pragma once
// Histogram adjustment: display brightness is spread as luminances are, but nowhere is contrast exaggerated. Brightness
// is ln of luminance in cd/m^2. Source: Ward Larson, Rushmeier & Piatko, "A Visibility Matching Tone Reproduction
// Operator for High Dynamic Range Scenes", IEEE Transactions on Visualization and Computer Graphics 3(4), 1997, section
// on histogram adjustment.

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "tonemap/scene_luminance.h"

namespace emulsion {

struct DisplayRange {
    double peak_cdm2 = 100.0;  ///< > 0
    double contrast = 100.0;   ///< peak over black; > 1
};

/// The steepest d ln(Ld) / d ln(Y) that is allowed at Y, shown as Ld, both in cd/m^2; > 0.
using ContrastCeiling = std::function<double(double luminance_cdm2, double displayed_cdm2)>;

/// Brightness of the display over that of the world: straight lines between knots that are ends of bins of
/// LuminanceHistogram, hence knots of LuminanceTable too. Below the first knot Ld is proportional to Y; past the last
/// one the last line goes on.
class BrightnessCurve {
  public:
    struct Knot {
        double luminance_cdm2, displayed_cdm2;
        double slope;  ///< d ln(Ld) / d ln(Y) from here to the next knot
    };
    /// One or more knots, of rising luminance, continuous.
    explicit BrightnessCurve(std::vector<Knot> knots) noexcept : knots_(std::move(knots)) {}

    /// Ld / Y; finite for every finite Y >= 0.
    [[nodiscard]] double displayed_over_luminance(double luminance_cdm2) const noexcept;

    [[nodiscard]] const std::vector<Knot>& knots() const noexcept { return knots_; }

  private:
    std::vector<Knot> knots_;
};

/// ln Ld = ln black + (ln peak - ln black) P(ln Y), black = peak / contrast, P being the cumulative distribution of ln
/// Y over the robust range, each luminance spread over a triangle that reaches a fifth of an octave to either side,
/// and what lies beyond the range put at its ends. Counts above the ceiling are trimmed until a pass trims no more than
/// 0.5 % of what it leaves, so that no slope is above the ceiling by more than that. None if (nearly) nothing is left:
/// under that ceiling the picture needs less than the display's range. It has positive pixels. Departs from the paper
/// in its samples, which are averages of 1 degree of the visual field (pictures here do not say how large they are
/// seen); in its 100 bins, of which it depends on the unit where they begin, and so what is trimmed of luminances that
/// lie close together (over six decades they are as wide as the triangle is at half its height); in its tolerance
/// of 2.5 % of all samples; and in that a thousandth of all counts is spread evenly over the range: else nothing would
/// be left of two luminances far apart.
[[nodiscard]] std::optional<BrightnessCurve> adjusted_histogram(const SceneLuminance& luminance,
                                                                const DisplayRange& display,
                                                                const ContrastCeiling& ceiling);

}  // namespace emulsion
