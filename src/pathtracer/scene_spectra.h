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
#include <string>
#include <vector>

#include "core/content_hash.h"
#include "pathtracer/scene.h"
#include "pathtracer/scene_parameters.h"
#include "spectrum/rgb_uplift.h"

namespace emulsion {

/// Files that a scene reads spectra from.
struct SpectrumFiles {
    std::filesystem::path folder;             ///< of relative names
    ContentHash contents;                     ///< of the files that were read, in the order of reading
    std::vector<std::filesystem::path> read;  ///< in that order

    /// The bytes of a file, noted here. \throws IoError
    [[nodiscard]] std::string read_file(const std::filesystem::path& path);
};

/// Reads the spectra of one scene.
class SpectrumReader {
  public:
    /// Relative file names are looked for in `folder`.
    explicit SpectrumReader(std::filesystem::path folder) : files_{std::move(folder), {}, {}} {}

    [[nodiscard]] const SpectrumFiles& files_read() const noexcept { return files_; }
    [[nodiscard]] SpectrumFiles& files() noexcept { return files_; }

    /// A reflectance.
    /// \throws SceneError if it is malformed, unknown, or outside [0, 1] at any of its points (pbrt-v4 refuses such RGB
    /// colours, and clamps tabulated values without a word).
    [[nodiscard]] Spectrum reflectance(const SceneParameter& parameter);

    /// The spectrum of a light in absolute units, scaled to a luminance of 1 cd/m^2, an intensity of 1 cd or an
    /// illuminance of 1 lux; that of an RGB light would be so were it white.
    /// \throws SceneError if it is malformed, unknown, negative anywhere, or 0 wherever it could be seen.
    [[nodiscard]] ScaledSpectrum light(const SceneParameter& parameter);

    /// The same of lights that have no such parameter: "stdillum-D65".
    [[nodiscard]] const ScaledSpectrum& default_light();

  private:
    [[nodiscard]] const RgbUplift& uplift();

    SpectrumFiles files_;
    // Both are made when they are first asked for.
    std::optional<RgbUplift> uplift_;
    std::optional<ScaledSpectrum> default_light_;
};

}  // namespace emulsion
