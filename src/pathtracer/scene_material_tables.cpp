// The tables of Material and MakeNamedMaterial.
#include <array>

#include "pathtracer/scene_tables.h"

namespace emulsion {

namespace {

using enum ValueKind;
using enum ValueRange;
using enum Support;

constexpr auto kDiffuse = std::to_array<ParameterSpec>({
    {.name = "reflectance", .kind = spectrum_or_texture},
    {.name = "displacement", .support = pbrt_only},
    {.name = "normalmap", .support = pbrt_only},
});
constexpr auto kMaterials = std::to_array<Implementation>({
    {"diffuse", kDiffuse},
    {"coatedconductor", {}, pbrt_only},
    {"coateddiffuse", {}, pbrt_only},
    {"conductor", {}, pbrt_only},
    {"dielectric", {}, pbrt_only},
    {"diffusetransmission", {}, pbrt_only},
    {"hair", {}, pbrt_only},
    {"interface", {}, pbrt_only},
    {"measured", {}, pbrt_only},
    {"mix", {}, pbrt_only},
    {"subsurface", {}, pbrt_only},
    {"thindielectric", {}, pbrt_only},
});
constexpr ImplementationTable kMaterialTable = {"material", kMaterials};

}  // namespace

const ImplementationTable& material_table() noexcept { return kMaterialTable; }

}  // namespace emulsion
