#pragma once
// Spectrum parameters to spectra:
//
//     "rgb L" [ r g b ]                   linear, in the space that ColorSpace names or sRGB; a smooth spectrum of that
//                                         colour under that space's illuminant (spectrum/rgb_uplift.h)
//     "blackbody L" [ T ]                 Planck's law at T kelvin, greatest value 1
//     "spectrum L" [ nm value nm value ]  straight lines between the points, 0 outside them
//     "spectrum L" "stdillum-A"           a named spectrum (spectrum/named_spectra.h)
//     "spectrum L" "lamp.spd"             a file of pairs as above, # begins a comment; relative to the scene file

#include <array>
#include <optional>

#include "pathtracer/scene.h"
#include "pathtracer/scene_files.h"
#include "pathtracer/scene_parameters.h"
#include "pathtracer/scene_warnings.h"
#include "spectrum/rgb_uplift.h"

namespace emulsion {

/// The spectrum brought into [0, 1] at every wavelength.
[[nodiscard]] Spectrum clamped_reflectance(Spectrum spectrum);

/// Reads the spectra of one scene.
class SpectrumReader {
  public:
    /// Both must outlive this.
    SpectrumReader(SceneFiles& files, SceneWarnings& warnings) noexcept : files_(&files), warnings_(&warnings) {}

    /// A reflectance. Tabulated values above 1 are kept, as a texture may make them less, and those below 0 are taken
    /// for 0; both are warned of. pbrt-v4 clamps what comes of them in the end, without a word.
    /// \throws SceneError if it is malformed, unknown, or an RGB colour outside [0, 1], as in pbrt-v4.
    [[nodiscard]] Spectrum reflectance(const SceneParameter& parameter);

    /// An index of refraction, or the k of one.
    /// \throws SceneError if it is malformed, unknown, or negative anywhere.
    [[nodiscard]] Spectrum index_of_refraction(const SceneParameter& parameter);

    /// The spectrum of a light in absolute units, scaled to a luminance of 1 cd/m^2, an intensity of 1 cd or an
    /// illuminance of 1 lux; that of an RGB light would be so were it white.
    /// \throws SceneError if it is malformed, unknown, negative anywhere, or 0 wherever it could be seen.
    [[nodiscard]] ScaledSpectrum light(const SceneParameter& parameter);

    /// The same of lights that have no such parameter: the illuminant of the colour space, D65 but for "aces2065-1".
    [[nodiscard]] const ScaledSpectrum& default_light(ColorSpace space);

  private:
    [[nodiscard]] const RgbUplift& uplift(ColorSpace space);

    SceneFiles* files_;
    SceneWarnings* warnings_;
    // By ColorSpace; made when they are first asked for.
    std::array<std::optional<RgbUplift>, kColorSpaces> uplifts_;
    std::array<std::optional<ScaledSpectrum>, kColorSpaces> default_lights_;
};

}  // namespace emulsion
