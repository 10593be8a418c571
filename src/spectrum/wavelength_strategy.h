#pragma once
// How the wavelengths of a path are drawn, as one named value: an arrangement and a density. A strategy is a choice and
// can be printed and parsed; wavelength_sampler.h makes it ready for the light of one scene.
//
// The relative RMS error of one estimate by strategy, number of wavelengths and light: docs/wavelength-sampling.md.

#include <array>
#include <string_view>
#include <variant>

#include "core/named_value.h"
#include "spectrum/wavelength_cells.h"

namespace emulsion {

/// Rotation over VisibleWavelengthPdf: needs nothing of the scene. The renderer's.
struct HeroVisible {
    static constexpr std::string_view kName = "hero-visible";
    static constexpr std::string_view kHelp = "rotation over a density that follows the eye";
    bool operator==(const HeroVisible&) const = default;
};

/// N independent wavelengths of uniform density: what the others are compared with.
struct IndependentUniform {
    static constexpr std::string_view kName = "independent";
    static constexpr std::string_view kHelp = "independent wavelengths of uniform density";
    bool operator==(const IndependentUniform&) const = default;
};

/// One wavelength anywhere in each of N equal bands.
struct StratifiedUniform {
    static constexpr std::string_view kName = "stratified";
    static constexpr std::string_view kHelp = "one wavelength anywhere in each of N equal bands";
    bool operator==(const StratifiedUniform&) const = default;
};

/// Equidistant wavelengths.
struct HeroUniform {
    static constexpr std::string_view kName = "hero-uniform";
    static constexpr std::string_view kHelp = "rotation over a uniform density";
    bool operator==(const HeroUniform&) const = default;
};

/// Rotation over TabulatedWavelengthPdf. Sees no delta lines.
struct HeroIlluminant {
    static constexpr std::string_view kName = "hero-illuminant";
    static constexpr std::string_view kHelp = "rotation over a density that follows eye and light";
    float uniform_share = kDefaultUniformShare;  ///< in kUniformShareRange
    bool operator==(const HeroIlluminant&) const = default;

    static constexpr std::array kParameters = {
        Parameter<HeroIlluminant>{"uniform-share", &HeroIlluminant::uniform_share, kUniformShareRange, "",
                                  "share of the samples spread evenly, whatever the light"}};
};

/// Rotation over LineWavelengthPdf. The only one that sees delta lines.
struct HeroLines {
    static constexpr std::string_view kName = "hero-lines";
    static constexpr std::string_view kHelp = "rotation over delta lines and a density that follows eye and light";
    float uniform_share = kDefaultUniformShare;  ///< in kUniformShareRange
    bool operator==(const HeroLines&) const = default;

    static constexpr std::array kParameters = {
        Parameter<HeroLines>{"uniform-share", &HeroLines::uniform_share, kUniformShareRange, "",
                             "share of the samples spread evenly, whatever the light"}};
};

/// All strategies; the first is the default.
using WavelengthStrategy =
    std::variant<HeroVisible, IndependentUniform, StratifiedUniform, HeroUniform, HeroIlluminant, HeroLines>;

}  // namespace emulsion
