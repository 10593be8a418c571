#pragma once
// Materials as a scene describes them. Both sides of a surface have the same material; a dielectric's inside is the
// side away from the normal.

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "pathtracer/scene_texture.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// Lambertian reflection.
struct DiffuseMaterial {
    ReflectanceParameter reflectance = Spectrum(ConstantSpectrum{0.5});
};

/// Of a microsurface. alpha = sqrt(roughness) if remapped, else alpha = roughness: GGX's parameter along the two
/// tangents of a surface. Below alpha = 1e-3 a surface is smooth.
struct Roughness {
    FloatParameter u = 0.0, v = 0.0;  ///< >= 0
    bool remap = true;
};

/// Index of refraction eta + i k, both > 0 resp. >= 0 at all wavelengths.
struct ComplexIor {
    Spectrum eta, k;
};

struct ConductorMaterial {
    /// By index of refraction, or by the reflectance at normal incidence.
    std::variant<ComplexIor, ReflectanceParameter> ior;
    Roughness roughness;
};

/// Glass: reflects and refracts. Wavelength-dependent eta disperses.
struct DielectricMaterial {
    Spectrum eta = ConstantSpectrum{1.5};  ///< inside over outside; > 0
    Roughness roughness;
};

/// Both surfaces of a pane without thickness, and what goes back and forth between them.
struct ThinDielectricMaterial {
    Spectrum eta = ConstantSpectrum{1.5};
};

/// Lambertian on both sides of the surface. As in pbrt-v4 nothing keeps the sum of both below 1.
struct DiffuseTransmissionMaterial {
    ReflectanceParameter reflectance = Spectrum(ConstantSpectrum{0.25});
    ReflectanceParameter transmittance = Spectrum(ConstantSpectrum{0.25});
    double scale = 1.0;
};

/// A dielectric coat over a Lambertian base.
struct CoatedDiffuseMaterial {
    ReflectanceParameter reflectance = Spectrum(ConstantSpectrum{0.5});
    Spectrum eta = ConstantSpectrum{1.5};
    Roughness roughness;
    double thickness = 0.01;  ///< of the coat, in mean free paths of what it absorbs; >= 0
    int max_depth = 10;       ///< of the light's way between coat and base, in meetings with either; >= 0
};

/// The second material with probability `amount`, else the first: indices into Scene::materials.
struct MixMaterial {
    int first = 0, second = 0;
    FloatParameter amount = 0.5;
};

/// Not there: rays pass. Shapes of it are left out of the scene.
struct InterfaceMaterial {};

using Material = std::variant<DiffuseMaterial, ConductorMaterial, DielectricMaterial, ThinDielectricMaterial,
                              DiffuseTransmissionMaterial, CoatedDiffuseMaterial, MixMaterial, InterfaceMaterial>;

/// A mix that contains itself, by its index; unset if none does.
/// \throws std::invalid_argument for a mix of a material that is not there.
[[nodiscard]] std::optional<std::size_t> endless_mix(const std::vector<Material>& materials);

}  // namespace emulsion
