#pragma once
// Spectrum parameters to spectra:
//
//     "rgb L" [ r g b ]                   linear sRGB; a smooth spectrum of that colour (spectrum/rgb_uplift.h)
//     "blackbody L" [ T ]                 Planck's law at T kelvin, greatest value 1
//     "spectrum L" [ nm value nm value ]  straight lines between the points, 0 outside them
//     "spectrum L" "stdillum-A"           a named spectrum (spectrum/named_spectra.h)
//     "spectrum L" "lamp.spd"             a file of pairs as above, # begins a comment; relative to the scene file

#include <filesystem>
#include <optional>

#include "pathtracer/scene.h"
#include "pathtracer/scene_parameters.h"
#include "spectrum/rgb_uplift.h"

namespace emulsion {

/// Reads the spectra of one scene.
class SpectrumReader {
  public:
    /// Relative file names are looked for in `folder`.
    explicit SpectrumReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// A reflectance.
    /// \throws SceneError if it is malformed, unknown, or outside [0, 1] at any of its points (pbrt-v4 refuses such RGB
    /// colours, and clamps tabulated values without a word).
    [[nodiscard]] Spectrum reflectance(const SceneParameter& parameter);

    /// The spectrum of a light; relative, see absolute().
    /// \throws SceneError if it is malformed, unknown, negative anywhere, or 0 wherever it could be seen.
    [[nodiscard]] Spectrum light(const SceneParameter& parameter);

  private:
    [[nodiscard]] const RgbUplift& uplift();

    std::filesystem::path folder_;
    std::optional<RgbUplift> uplift_;  // made for the first RGB colour
};

/// The default of lights: "stdillum-D65".
[[nodiscard]] Spectrum default_light_spectrum();

/// The spectrum of a light in absolute units: `photometric_scale` is its luminance in cd/m^2, intensity in cd or
/// illuminance in lux; those of an RGB light if it were white.
[[nodiscard]] ScaledSpectrum absolute(Spectrum spectrum, double photometric_scale);

}  // namespace emulsion
