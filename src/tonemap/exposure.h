#pragma once
// What a camera does without a film curve: exposure, metered and compensated.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// Ld = 0.18 * 2^ev Y / Ya: linear; what the meter reads, Ya, becomes middle grey, and each stop doubles it. As
/// exposure compensation of a camera, ev is relative to the meter, not an absolute exposure: `fixed` is that. What is
/// brighter comes out above 1. Source: none; as a light meter and a grey card of 18 % are used.
struct Exposure {
    static constexpr std::string_view kName = "exposure";
    static constexpr std::string_view kHelp = "linear, what is metered becomes middle grey";
    static constexpr OperatorTraits kTraits = {};
    float ev = 0.0f;  ///< exposure compensation in stops; in [-100, 100]
    bool operator==(const Exposure&) const = default;

    static constexpr std::array kParameters = {Parameter<Exposure>{
        "ev", &Exposure::ev, {-100.0, 100.0}, "stops", "exposure compensation, each stop is twice as bright"}};
};

[[nodiscard]] Adaptation own_adaptation(const Exposure& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const Exposure& mapper, const SceneLuminance& luminance, double adaptation_cdm2);

}  // namespace emulsion
