#pragma once
// How light is carried from lights over surfaces to the film: by which numbers a spectrum is stood for. Plain values
// that can be printed and parsed; fixed_channels.h and transport.h have what they stand for.
//
//     rgb[:SPACE]              three channels of a linear RGB space, or of "sharp"
//     rgb-prefiltered          three sharp channels, reflectances as they look under the scene's light
//     basis:K                  K functions made from the scene's own spectra
//     spectral:N[:STRATEGY]    N wavelengths to a path, drawn by one of spectrum/wavelength_strategy.h
//
// Only the last is right for every scene, in the mean over many paths; the others are the same for every path, so that
// they have no colour noise, and an error that no number of samples takes away.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/matrix3.h"
#include "spectrum/wavelength_strategy.h"

namespace emulsion {

/// The name of channels that no RGB space has: responses narrower than those of cones, and almost never negative.
/// Source: Süsstrunk, Holm & Finlayson, "Chromatic Adaptation Performance of Different RGB Sensors", SPIE 4300, 2001.
inline constexpr std::string_view kSharpChannels = "sharp";

/// Reflectances as RGB under the white of the space, lights as RGB: what most renderers do.
struct RgbModel {
    static constexpr std::string_view kName = "rgb";
    std::string space = "sRGB";  ///< a name that channel_space_from_xyz() knows
    bool operator==(const RgbModel&) const = default;
};

/// Reflectances as the ratio of what they look like under the scene's light to the light itself, in three channels
/// narrower than cones. One bounce from a light of that spectrum is exact.
/// Source: Ward & Eydelberg-Vileshin, "Picture Perfect RGB Rendering Using Spectral Prefiltering and Sharp Color
/// Primaries", EG Workshop on Rendering 2002. Theirs is the dominant light's; ours that of all lights by their flux.
struct PrefilteredRgbModel {
    static constexpr std::string_view kName = "rgb-prefiltered";
    bool operator==(const PrefilteredRgbModel&) const = default;
};

inline constexpr int kFewestBasisFunctions = 3, kMostBasisFunctions = 8;

/// channel_basis.h. Light that comes straight from a light is exact.
struct BasisModel {
    static constexpr std::string_view kName = "basis";
    int functions = 6;  ///< in [kFewestBasisFunctions, kMostBasisFunctions]
    bool operator==(const BasisModel&) const = default;
};

struct SpectralModel {
    static constexpr std::string_view kName = "spectral";
    int wavelengths = 4;  ///< one of kWavelengthCounts
    WavelengthStrategy strategy = HeroVisible{};
    bool operator==(const SpectralModel&) const = default;
};

using TransportModel = std::variant<SpectralModel, RgbModel, PrefilteredRgbModel, BasisModel>;

/// "spectral:4", "spectral:8:hero-illuminant:uniform-share=0.1", "rgb:sRGB", "basis:6": reads back as the same.
[[nodiscard]] std::string to_text(const TransportModel& model);

/// What may be left out has its default: "spectral", "rgb", "basis"; with its colon. Names as core/name_key.h has them.
/// \param others forms that might have stood there besides, for the list of those that are expected
/// \throws std::invalid_argument naming what was found and what was expected.
[[nodiscard]] TransportModel parse_transport_model(std::string_view text, std::string_view others = {});

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const TransportModel& model);

struct TransportModelDescription {
    std::string form;  ///< "basis:K"
    std::string help;  ///< one line, no full stop
};
/// For --help, in the order of cost.
[[nodiscard]] std::vector<TransportModelDescription> describe_transport_models();

/// Linear channels from CIE 1931 XYZ: those of an RGB space (spectrum/rgb_space.h), or kSharpChannels.
/// \throws std::invalid_argument for an unknown name, listing those that exist.
[[nodiscard]] Matrix3 channel_space_from_xyz(std::string_view name);

}  // namespace emulsion
