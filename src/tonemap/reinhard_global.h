#pragma once
// The global part of photographic tone reproduction. Scaled luminance L is dimensionless: 1 at display white for small
// L and infinite white. Display luminance Ld is relative: 1 is display white.

#include <array>
#include <limits>
#include <string_view>

#include "core/color.h"
#include "core/image.h"
#include "core/parameters.h"
#include "tonemap/luminance_statistics.h"

namespace emulsion {

/// L = key Y / log_average(Y);  Ld = L (1 + L / white^2) / (1 + L): exactly 1 at L = white, and rising for every white.
/// Independent of the unit of luminance. Tone curve only: no gamut mapping, no transfer function; luminances past
/// `white` come out above 1.
/// Source: Reinhard, Stark, Shirley & Ferwerda, "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002,
/// eq. 1, 2, 4. Departs from it in the log-average: see LuminanceStatistics.
struct ReinhardGlobal {
    static constexpr std::string_view kName = "reinhard-global";
    static constexpr std::string_view kHelp = "photographic tone reproduction, one curve for all pixels";
    float key = 0.18f;                                     ///< L given to the log-average; finite, > 0
    float white = std::numeric_limits<float>::infinity();  ///< smallest L mapped to display white; > 0
    bool operator==(const ReinhardGlobal&) const = default;

    static constexpr std::array kParameters = {
        Parameter<ReinhardGlobal>{"key", &ReinhardGlobal::key, kPositiveFinite, "",
                                  "scaled luminance given to the log-average; larger is brighter"},
        Parameter<ReinhardGlobal>{"white", &ReinhardGlobal::white, kPositive, "",
                                  "smallest scaled luminance shown as display white"}};
};

/// Ld for a scaled luminance L in [0, 1e100]; the curve alone, in double precision.
[[nodiscard]] double display_luminance(const ReinhardGlobal& mapper, double scaled_luminance) noexcept;

/// Ld / Y, in 1/(cd/m^2), for a luminance >= 0 and finite; the double-precision twin of apply(). Its limit at Y = 0;
/// 0 if the picture has no positive pixel.
[[nodiscard]] double luminance_scale(const ReinhardGlobal& mapper, const LuminanceStatistics& statistics,
                                     double luminance_cdm2) noexcept;

/// Scales every pixel, in single precision within 1e-6 of the twin; bad pixels as tone_map() says. `display` has the
/// size of `scene`, and may be the same pixels. \throws std::invalid_argument if threads < 0.
void apply(const ReinhardGlobal& mapper, const LuminanceStatistics& statistics, ImageView<const XYZ> scene,
           ImageView<XYZ> display, const XYZ& display_white, int threads);

}  // namespace emulsion
