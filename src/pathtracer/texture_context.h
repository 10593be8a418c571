#pragma once

#include <Imath/ImathMatrix.h>

#include "pathtracer/scene.h"
#include "pathtracer/scene_files.h"
#include "pathtracer/scene_spectra.h"
#include "pathtracer/scene_warnings.h"

namespace emulsion {

/// What a Texture directive stands in: the scene that the texture becomes part of, what reads its spectra and files,
/// where warnings go, and the current transformation.
struct TextureContext {
    Scene& scene;
    SpectrumReader& spectra;
    SceneFiles& files;
    SceneWarnings& warnings;
    Imath::M44d world_from_texture;
};

}  // namespace emulsion
