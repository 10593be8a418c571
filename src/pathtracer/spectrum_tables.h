#pragma once
// The spectra of a scene as the renderer keeps them, by index.

#include <cstdint>
#include <vector>

#include "core/matrix3.h"
#include "pathtracer/scene_light.h"
#include "pathtracer/transport.h"
#include "spectrum/reflectance_weights.h"

namespace emulsion {

class SpectrumTables {
  public:
    SpectrumTables();

    /// A reflectance or another property of surfaces: as RGB, the mean that D65 and the eye see.
    /// \throws std::invalid_argument as SpectrumTable does.
    [[nodiscard]] std::uint32_t add_property(const Spectrum& spectrum);
    /// A light: as RGB, its colour in cd/m^2 (or candela, or lux).
    /// \throws std::invalid_argument as SpectrumTable does.
    [[nodiscard]] std::uint32_t add_light(const ScaledSpectrum& light);

    [[nodiscard]] const PreparedSpectrum& operator[](std::uint32_t i) const noexcept { return spectra_[i]; }

  private:
    ReflectanceRgb rec709_;
    Matrix3 rgb_from_xyz_;
    std::vector<PreparedSpectrum> spectra_;
};

}  // namespace emulsion
