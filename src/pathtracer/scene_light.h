#pragma once
// Lights as a scene describes them. Their spectra are absolute: the photometric normalisation of pbrt-v4 has been
// applied by whoever filled this in.

#include <memory>
#include <variant>
#include <vector>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "core/color.h"
#include "core/image.h"
#include "pathtracer/scene_color_space.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// spectrum(lambda) * scale.
struct ScaledSpectrum {
    Spectrum spectrum;
    double scale = 1.0;
    bool operator==(const ScaledSpectrum&) const = default;
};

/// Of a shape: emits `radiance`, W m^-2 sr^-1 nm^-1, to the side of the geometric normal, or to both.
struct AreaLight {
    ScaledSpectrum radiance;
    bool two_sided = false;
    std::vector<float> triangle_scale = {};  ///< of a mesh: triangle i emits this times `radiance`; empty: 1 for all
};

// --- Lights without a shape

struct PointLight {
    Imath::V3d position;
    ScaledSpectrum intensity;  ///< W sr^-1 nm^-1
};

/// A point that shines into a cone about +z of light space: with full intensity up to the first angle from the axis,
/// with none past the second, and in between with 3 t^2 - 2 t^3 of it, t rising evenly with the cosine.
struct SpotLight {
    Imath::V3d position;
    Imath::M44d light_from_world;           ///< of directions; where it stretches space, the cone is none
    ScaledSpectrum intensity;               ///< along the axis, W sr^-1 nm^-1
    double cos_full = 1.0, cos_none = 0.0;  ///< cosines of the two angles; cos_full >= cos_none
};

struct DistantLight {
    Imath::V3d to_light;        ///< unit vector towards the light
    ScaledSpectrum irradiance;  ///< on a surface that faces it, W m^-2 nm^-1
};

/// The same radiance from everywhere that no shape hides.
struct UniformInfiniteLight {
    ScaledSpectrum radiance;  ///< W m^-2 sr^-1 nm^-1
};

/// A picture of the radiance from everywhere: square, in Clarberg's equal-area octahedral mapping of the directions of
/// light space. A texel (r, g, b) is the light `illuminant` * 2 m * sigmoid(rgb / 2m), m being its largest component.
struct ImageInfiniteLight {
    std::shared_ptr<const Image<RGB>> texels;  ///< linear RGB, >= 0
    ScaledSpectrum illuminant;                 ///< W m^-2 sr^-1 nm^-1 of the texel (1, 1, 1)
    Imath::M44d world_from_light;              ///< of directions: a rotation, maybe mirrored
    ColorSpace space = ColorSpace::srgb;       ///< of the texels
};

using Light = std::variant<PointLight, SpotLight, DistantLight, UniformInfiniteLight, ImageInfiniteLight>;

}  // namespace emulsion
