#pragma once
// What varies over surfaces, as a scene describes it. A scene's textures lie in two lists, of numbers and of
// reflectances; each refers to textures of smaller index only, so that none can depend on itself.

#include <filesystem>
#include <memory>
#include <variant>
#include <vector>

#include <Imath/ImathMatrix.h>

#include "core/color.h"
#include "core/image.h"
#include "pathtracer/scene_color_space.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// A texture of the scene, by its index in the list of its kind.
struct TextureIndex {
    int index = 0;
    bool operator==(const TextureIndex&) const = default;
};

/// A number, or what one of Scene::float_textures gives.
using FloatParameter = std::variant<double, TextureIndex>;
/// A reflectance in [0, 1] (of an operand of textures, >= 0), or what one of Scene::reflectance_textures gives.
using ReflectanceParameter = std::variant<Spectrum, TextureIndex>;

// --- Where on a texture a point of a surface lies

/// (scale_u u + delta_u, scale_v v + delta_v) of the surface's own parameters.
struct UvMapping {
    double scale_u = 1.0, scale_v = 1.0, delta_u = 0.0, delta_v = 0.0;
};
/// (theta / pi, phi / 2 pi) of the direction from the origin of texture space, z up, phi in [0, 2 pi).
struct SphericalTextureMapping {
    Imath::M44d texture_from_world;
};
/// (phi / 2 pi + 1/2, z), phi in (-pi, pi].
struct CylindricalTextureMapping {
    Imath::M44d texture_from_world;
};
/// (p . along_u + delta_u, p . along_v + delta_v) of the point p of texture space.
struct PlanarTextureMapping {
    Imath::M44d texture_from_world;
    Imath::V3d along_u{1.0, 0.0, 0.0}, along_v{0.0, 1.0, 0.0};
    double delta_u = 0.0, delta_v = 0.0;
};
/// The point of texture space itself.
struct SolidTextureMapping {
    Imath::M44d texture_from_world;
};
using TextureMapping =
    std::variant<UvMapping, SphericalTextureMapping, CylindricalTextureMapping, PlanarTextureMapping>;

// --- Textures; Parameter is FloatParameter or ReflectanceParameter

/// texture * scale.
template <class Parameter>
struct ScaleTexture {
    Parameter texture;
    FloatParameter scale = 1.0;
};
/// (1 - amount) first + amount second.
template <class Parameter>
struct MixTexture {
    Parameter first, second;
    FloatParameter amount = 0.5;
};
/// first where the whole parts of the mapped u and v, or of x, y and z, have an even sum, else second.
template <class Parameter>
struct CheckerboardTexture {
    Parameter first, second;
    std::variant<TextureMapping, SolidTextureMapping> mapping;
};

enum class TextureWrap { repeat, black, clamp, octahedral_sphere };
/// Of the four texels around a point: the one that it lies on; straight lines along both directions; or a bell of one
/// texel's radius about the point, exp(-2 r^2) - exp(-2).
enum class TextureFilter { nearest, bilinear, gaussian };

/// A picture file, decoded to linear values; shared by the textures that use it. Row 0 is the top row: (u, v) = (0, 1)
/// is its left top corner.
template <class Texel>
struct TextureImage {
    std::filesystem::path file;
    Image<Texel> texels;
    ColorSpace space = ColorSpace::srgb;  ///< of texels of RGB
};

/// scale * texel, inverted to 1 - that if asked for, and clamped to [0, 1] for reflectances.
template <class Texel>
struct ImageTexture {
    std::shared_ptr<const TextureImage<Texel>> image;
    TextureMapping mapping;
    TextureWrap wrap = TextureWrap::repeat;
    TextureFilter filter = TextureFilter::bilinear;
    double scale = 1.0;
    bool invert = false;
};

using FloatTexture = std::variant<ScaleTexture<FloatParameter>, MixTexture<FloatParameter>,
                                  CheckerboardTexture<FloatParameter>, ImageTexture<float>>;
/// Images of reflectances are linear RGB; spectrum/sigmoid_table.h makes spectra of them.
using ReflectanceTexture = std::variant<ScaleTexture<ReflectanceParameter>, MixTexture<ReflectanceParameter>,
                                        CheckerboardTexture<ReflectanceParameter>, ImageTexture<RGB>>;

}  // namespace emulsion
