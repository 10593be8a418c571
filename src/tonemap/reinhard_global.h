#pragma once
// The global part of photographic tone reproduction. Scaled luminance L is dimensionless: 1 at display white for small
// L and infinite white. Display luminance Ld is relative: 1 is display white.

#include <array>
#include <limits>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// L = key Y / Ya;  Ld = L (1 + L / white^2) / (1 + L): 1 at L = white, to the last bit of a float, and rising for
/// every white. Ya is the log-average, unless chosen otherwise. Luminances past `white` come out above 1. The white may
/// be
///     a number: the smallest L shown as display white; infinite, none is;
///     "max": L of the robust largest luminance, which burns out a thousandth of the pixels, to a bin (0.14 % at most).
///         It is what the paper of 2002 takes if nothing is set, but for being robust;
///     "auto": photographic_white(), the recommendation of the paper of 2003.
/// Sources: Reinhard, Stark, Shirley & Ferwerda, "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002,
/// eq. 1, 2, 4; for what is automatic, Reinhard, "Parameter Estimation for Photographic Tone Reproduction", Journal of
/// Graphics Tools 7(1), 2003. Departs from the first in the log-average (see LuminanceStatistics) and in the largest
/// luminance, for which it takes the robust one of SceneLuminance.
struct ReinhardGlobal {
    static constexpr float kAutoWhite = 0.0f, kMaxWhite = -1.0f;

    static constexpr std::string_view kName = "reinhard-global";
    static constexpr std::string_view kHelp = "photographic tone reproduction, one curve for all pixels";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::nearly_cancels};
    float key = 0.18f;                                     ///< L given to Ya; finite, > 0, or 0: photographic_key()
    float white = std::numeric_limits<float>::infinity();  ///< smallest L shown as white; > 0, or one of the two above
    bool operator==(const ReinhardGlobal&) const = default;

    static constexpr std::array kWhites = {ParameterWord{"auto", static_cast<int>(kAutoWhite)},
                                           ParameterWord{"max", static_cast<int>(kMaxWhite)}};
    static constexpr std::array kParameters = {
        Parameter<ReinhardGlobal>{
            "key", &ReinhardGlobal::key, kPositiveFinite, "",
            "scaled luminance given to the adaptation luminance, larger is brighter; auto: from the range", kAutomatic},
        Parameter<ReinhardGlobal>{
            "white", &ReinhardGlobal::white, kPositive, "",
            "smallest scaled luminance shown as display white; auto: from the range; max: of the brightest pixels",
            kWhites}};
};

/// The two estimates of Reinhard 2003, from the log-average Lav and the least and the largest luminance Lmin and Lmax.
/// As in the paper, the darkest and the brightest hundredth of the pixels are left out of the latter two; so are the
/// outliers of SceneLuminance, which may be more than that of small pictures.

/// 0.18 * 4^((2 log2 Lav - log2 Lmin - log2 Lmax) / (log2 Lmax - log2 Lmin)); 0.18 if the ends are the same.
[[nodiscard]] double photographic_key(const SceneLuminance& luminance);

/// Scaled luminance: 1.5 * 2^(log2 Lmax - log2 Lmin - 5), but no less than the key: of a range below two octaves or so
/// it would burn out what the picture is adapted to. Departs from the paper in that. A ratio of two ends that are known
/// to a bin's width, which the curve then squares: in another unit, pixels of a photograph moved by up to 4.2/255.
[[nodiscard]] double photographic_white(const SceneLuminance& luminance, double key);

[[nodiscard]] Adaptation own_adaptation(const ReinhardGlobal& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const ReinhardGlobal& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
