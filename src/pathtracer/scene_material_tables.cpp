// The tables of Material and MakeNamedMaterial.
#include <array>

#include "pathtracer/scene_tables.h"

namespace emulsion {

namespace {

using enum ValueKind;
using enum ValueRange;
using enum Support;

constexpr ParameterSpec kReflectance = {.name = "reflectance", .kind = spectrum_or_texture};
constexpr ParameterSpec kEta = {.name = "eta", .kind = real_or_spectrum};
constexpr ParameterSpec kRoughness = {.name = "roughness", .kind = real_or_texture, .range = not_negative};
constexpr ParameterSpec kRoughnessU = {.name = "uroughness", .kind = real_or_texture, .range = not_negative};
constexpr ParameterSpec kRoughnessV = {.name = "vroughness", .kind = real_or_texture, .range = not_negative};
constexpr ParameterSpec kRemap = {.name = "remaproughness", .kind = boolean};
constexpr ParameterSpec kDisplacement = {.name = "displacement", .support = pbrt_only};
constexpr ParameterSpec kNormalMap = {.name = "normalmap", .support = pbrt_only};

constexpr auto kDiffuse = std::to_array<ParameterSpec>({kReflectance, kDisplacement, kNormalMap});
constexpr auto kConductor = std::to_array<ParameterSpec>({
    {.name = "eta", .kind = spectrum},
    {.name = "k", .kind = spectrum},
    kReflectance,
    kRoughness,
    kRoughnessU,
    kRoughnessV,
    kRemap,
    kDisplacement,
    kNormalMap,
});
constexpr auto kDielectric =
    std::to_array<ParameterSpec>({kEta, kRoughness, kRoughnessU, kRoughnessV, kRemap, kDisplacement, kNormalMap});
constexpr auto kThinDielectric = std::to_array<ParameterSpec>({kEta, kDisplacement, kNormalMap});
constexpr auto kDiffuseTransmission = std::to_array<ParameterSpec>({
    kReflectance,
    {.name = "transmittance", .kind = spectrum_or_texture},
    {.name = "scale", .range = not_negative},
    kDisplacement,
    kNormalMap,
});
constexpr auto kCoatedDiffuse = std::to_array<ParameterSpec>({
    kReflectance,
    kEta,
    kRoughness,
    kRoughnessU,
    kRoughnessV,
    kRemap,
    {.name = "thickness", .range = not_negative},
    {.name = "albedo", .kind = spectrum},
    {.name = "g"},
    {.name = "maxdepth", .kind = integer, .range = not_negative},
    {.name = "nsamples", .kind = integer, .range = positive},
    kDisplacement,
    kNormalMap,
});
constexpr auto kMix = std::to_array<ParameterSpec>({
    {.name = "materials", .kind = string, .count = 2},
    {.name = "amount", .kind = real_or_texture},
});
constexpr auto kMaterials = std::to_array<Implementation>({
    {"diffuse", kDiffuse},
    {"conductor", kConductor},
    {"dielectric", kDielectric},
    {"thindielectric", kThinDielectric},
    {"diffusetransmission", kDiffuseTransmission},
    {"coateddiffuse", kCoatedDiffuse},
    {"mix", kMix},
    {"interface"},
    {"coatedconductor", {}, pbrt_only},
    {"hair", {}, pbrt_only},
    {"measured", {}, pbrt_only},
    {"subsurface", {}, pbrt_only},
});
constexpr ImplementationTable kMaterialTable = {"material", kMaterials};

}  // namespace

const ImplementationTable& material_table() noexcept { return kMaterialTable; }

}  // namespace emulsion
