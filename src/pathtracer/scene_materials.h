#pragma once
// Material parameters to materials, with the defaults of pbrt-v4. Index of refraction by number, by spectrum or by name
// ("glass-BK7", "metal-Ag-eta"); `uroughness` and `vroughness` are `roughness` unless given.

#include <functional>
#include <string>

#include "pathtracer/scene_material.h"
#include "pathtracer/scene_parameters.h"
#include "pathtracer/scene_spectra.h"
#include "pathtracer/scene_textures.h"

namespace emulsion {

struct MaterialContext {
    const SceneTextures& textures;
    SpectrumReader& spectra;
    /// The index in Scene::materials that is, or will be, that of a named material.
    std::function<int(const SourcePlace& place, const std::string& name)> named;
};

/// The list's owner names the material.
/// \throws SceneError naming the token at fault.
[[nodiscard]] Material read_material(const ParameterList& list, const MaterialContext& context);

}  // namespace emulsion
