#pragma once
// What a scene file says, as plain values: left-handed axes as in pbrt, lengths in the scene's own unit.
//
// What is called world space here has its origin at the camera, wherever the file's own is, and the axes of the file's.
// Coordinates are brought there in double precision before anything is rounded: a scene that was moved far away is the
// same scene, and the finest numbers are those near the eye.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Imath/ImathVec.h>

#include "core/image.h"
#include "film/filter.h"
#include "film/pixel_type.h"
#include "film/sensor_options.h"
#include "film/spectral_buckets.h"
#include "pathtracer/scene_camera.h"
#include "pathtracer/scene_geometry.h"
#include "pathtracer/scene_light.h"
#include "pathtracer/scene_material.h"
#include "pathtracer/scene_texture.h"

namespace emulsion {

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
    std::optional<SpectralBuckets> spectrum = std::nullopt;  ///< of film "spectral"
};

/// What is random within a pixel. Without it all paths of a pixel start at its centre, in the middle of the lens, or
/// with the same wavelengths: wrong pictures, but comparable ones.
struct SampleJitter {
    bool pixel = true, wavelength = true;
};

struct PathIntegratorSettings {
    int max_depth = 5;  ///< longest path, in scattering events; 0: light seen directly only
};

struct Scene {
    Imath::V3d origin{0.0};  ///< of world space, as the file counts: where its camera is
    Camera camera;
    FilmSettings film;
    Filter filter = GaussianFilter{};
    Sampler sampler = PaddedSobolSampler{};
    int sampler_seed = 0;
    SampleJitter jitter;
    PathIntegratorSettings integrator;
    std::vector<FloatTexture> float_textures;
    std::vector<ReflectanceTexture> reflectance_textures;
    std::vector<Material> materials;
    std::vector<Shape> shapes;
    std::vector<ObjectDefinition> objects;
    std::vector<ObjectInstance> instances;
    std::vector<Light> lights;
    /// Of the contents of all files that the scene was read from (core/content_hash.h); empty: of no file.
    std::string hash;
    std::vector<std::filesystem::path> files;  ///< that were read, beside the scene file itself
    std::vector<std::string> warnings;         ///< file:line:column: what was taken otherwise than written, and how
};

}  // namespace emulsion
