#pragma once
// Brightness as it is seen, for one who is adapted to the scene and one adapted to the display.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// Ld = m (Lda / peak) (Y / Ya)^(g(Ya) / g(Lda)),  m = sqrt(contrast)^(g(Ya) / g(Lda) - 1),  Lda = peak /
/// sqrt(contrast), g = stevens_exponent(). Needs luminances in cd/m^2.
/// Source: Tumblin, Hodgins & Guenter, "Two Methods for Display of High Contrast Images", ACM Transactions on Graphics
/// 18(1), 1999, appendix: the revision of Tumblin & Rushmeier, "Tone Reproduction for Realistic Images", IEEE Computer
/// Graphics and Applications 13(6), 1993. The logarithm in m is that to base 10, as in g; some programs take the
/// natural one. Departs from it where the power, less than 1, is infinitely steep: Y / Ya is replaced by sqrt((Y /
/// Ya)^2 + e^2) in Ld / Y, e being a thousandth of the robust least Y / Ya, and Ld is linear below. Under local
/// adaptation the exponent remains that of the picture.
struct TumblinRushmeier {
    static constexpr std::string_view kName = "tumblin-rushmeier";
    static constexpr std::string_view kHelp = "keeps brightness as it is seen; needs cd/m^2";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::absolute};
    float peak = 100.0f;     ///< luminance of display white, cd/m^2; in [1, 1e5]
    float contrast = 50.0f;  ///< of display white over its black; in [1, 1e6]
    bool operator==(const TumblinRushmeier&) const = default;

    static constexpr std::array kParameters = {
        Parameter<TumblinRushmeier>{
            "peak", &TumblinRushmeier::peak, {1.0, 1e5}, "cd/m^2", "luminance of display white"},
        Parameter<TumblinRushmeier>{
            "contrast", &TumblinRushmeier::contrast, {1.0, 1e6}, "", "of the display, white over black"}};
};

/// Exponent of brightness over luminance for an eye adapted to `adaptation_cdm2`: 1.855 + 0.4 log10(La + 2.3e-5), at
/// most 2.655, which it reaches at 100 cd/m^2. Held above 0, where the formula gives -0.0003 for no light at all.
[[nodiscard]] double stevens_exponent(double adaptation_cdm2) noexcept;

[[nodiscard]] Adaptation own_adaptation(const TumblinRushmeier& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const TumblinRushmeier& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
