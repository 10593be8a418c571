#pragma once
// What a scene file says, as plain values in world space: left-handed axes as in pbrt, lengths in the scene's own unit.
// Light spectra are absolute: the photometric normalisation of pbrt-v4 has been applied by whoever filled this in.

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "core/image.h"
#include "film/filter.h"
#include "film/pixel_type.h"
#include "film/sensor_options.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// spectrum(lambda) * scale.
struct ScaledSpectrum {
    Spectrum spectrum;
    double scale = 1.0;
    bool operator==(const ScaledSpectrum&) const = default;
};

// --- Camera

/// A pinhole at the origin of camera space that looks along +z, with y up and x to the right.
struct PerspectiveCamera {
    Imath::M44d world_from_camera;  ///< Imath's convention: row vectors, p * M
    double fov_deg = 90.0;          ///< full angle along the shorter side of the picture; in (0, 180)
    /// x min, x max, y min, y max on the plane z = 1 in units of tan(fov/2); unset: the shorter side spans [-1, 1].
    std::optional<std::array<double, 4>> screen_window;
    std::optional<double> frame_aspect_ratio;  ///< width / height; unset: that of the resolution
};

// --- Materials and shapes

/// Lambertian reflection; reflectance in [0, 1].
struct DiffuseMaterial {
    Spectrum reflectance = ConstantSpectrum{0.5};
};

using Material = std::variant<DiffuseMaterial>;

struct TriangleMesh {
    std::vector<Imath::V3f> position;  ///< world space
    std::vector<Imath::V3f> normal;    ///< shading normals in world space: one a position, or none
    std::vector<std::array<std::uint32_t, 3>> triangle;
    bool flip_normal = false;  ///< geometric normal: (p1 - p0) x (p2 - p0), turned round if set
};

/// The sphere of radius `radius` about the origin of object space; world_from_object may be any invertible affine map.
struct Sphere {
    Imath::M44d world_from_object;
    double radius = 1.0;       ///< > 0
    bool flip_normal = false;  ///< outward normal, turned inward if set
};

/// Emits `radiance`, W m^-2 sr^-1 nm^-1, to the side of the geometric normal, or to both.
struct AreaLight {
    ScaledSpectrum radiance;
    bool two_sided = false;
    std::vector<float> triangle_scale = {};  ///< of a mesh: triangle i emits this times `radiance`; empty: 1 for all
};

struct Shape {
    std::variant<TriangleMesh, Sphere> geometry;
    int material = 0;  ///< index into Scene::materials
    std::optional<AreaLight> area_light;
};

// --- Lights without a shape

struct PointLight {
    Imath::V3d position;
    ScaledSpectrum intensity;  ///< W sr^-1 nm^-1
};

struct DistantLight {
    Imath::V3d to_light;        ///< unit vector towards the light
    ScaledSpectrum irradiance;  ///< on a surface that faces it, W m^-2 nm^-1
};

/// The same radiance from everywhere that no shape hides.
struct UniformInfiniteLight {
    ScaledSpectrum radiance;  ///< W m^-2 sr^-1 nm^-1
};

using Light = std::variant<PointLight, DistantLight, UniformInfiniteLight>;

// --- How to render it

struct IndependentSampler {
    int samples_per_pixel = 16;
};
/// x_samples * y_samples strata of the pixel and of every pair of dimensions.
struct StratifiedSampler {
    int x_samples = 4, y_samples = 4;
    bool jitter = true;
};
/// Owen-scrambled Sobol' points, two dimensions at a time.
struct PaddedSobolSampler {
    int samples_per_pixel = 16;
};
using Sampler = std::variant<IndependentSampler, StratifiedSampler, PaddedSobolSampler>;

struct FilmSettings {
    int width_px = 1280, height_px = 720;
    std::string filename;       ///< as the scene gives it; empty if it doesn't
    SensorOptions sensor = {};  ///< the exposure time is the camera's
    PixelType pixel_type = PixelType::float32;
    /// x0, x1, y0, y1 of the pixels to render, as parts of width and height in [0, 1], each rounded up to whole pixels;
    /// unset: all. pixel_bounds says the same in pixels; at most one of the two is set.
    std::optional<std::array<double, 4>> crop_window = std::nullopt;
    std::optional<PixelBounds> pixel_bounds = std::nullopt;
};

struct PathIntegratorSettings {
    int max_depth = 5;  ///< longest path, in scattering events; 0: light seen directly only
};

struct Scene {
    PerspectiveCamera camera;
    FilmSettings film;
    Filter filter = GaussianFilter{};
    Sampler sampler = PaddedSobolSampler{};
    int sampler_seed = 0;
    PathIntegratorSettings integrator;
    std::vector<Material> materials;
    std::vector<Shape> shapes;
    std::vector<Light> lights;
    /// Of the contents of all files that the scene was read from (core/content_hash.h); empty: of no file.
    std::string hash;
    std::vector<std::filesystem::path> files;  ///< that were read, beside the scene file itself
    std::vector<std::string> warnings;         ///< file:line:column: what was taken otherwise than written, and how
};

}  // namespace emulsion
