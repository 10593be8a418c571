// The tables of what may stand after WorldBegin.
#include <array>

#include "pathtracer/scene_tables.h"

namespace emulsion {

namespace {

using enum ValueKind;
using enum ValueRange;
using enum Support;

// --- Material

constexpr auto kDiffuse = std::to_array<ParameterSpec>({
    {.name = "reflectance", .kind = spectrum},
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

// --- Lights

constexpr ParameterSpec kRadiance = {.name = "L", .kind = spectrum};
constexpr ParameterSpec kIntensity = {.name = "I", .kind = spectrum};
constexpr ParameterSpec kScale = {.name = "scale", .range = not_negative};
constexpr ParameterSpec kPower = {.name = "power", .range = positive};
constexpr ParameterSpec kIlluminance = {.name = "illuminance", .range = positive};
constexpr ParameterSpec kFrom = {.name = "from", .kind = point3};
constexpr ParameterSpec kTo = {.name = "to", .kind = point3};

constexpr auto kDiffuseLight = std::to_array<ParameterSpec>(
    {kRadiance, kScale, kPower, {.name = "twosided", .kind = boolean}, {.name = "filename", .support = pbrt_only}});
constexpr auto kAreaLights = std::to_array<Implementation>({{"diffuse", kDiffuseLight}});
constexpr ImplementationTable kAreaLightTable = {"area light", kAreaLights};

constexpr auto kPoint = std::to_array<ParameterSpec>({kIntensity, kScale, kPower, kFrom});
constexpr auto kDistant = std::to_array<ParameterSpec>({kRadiance, kScale, kIlluminance, kFrom, kTo});
constexpr auto kInfinite = std::to_array<ParameterSpec>({
    kRadiance,
    kScale,
    kIlluminance,
    {.name = "filename", .support = pbrt_only},
    {.name = "portal", .support = pbrt_only},
});
constexpr auto kLights = std::to_array<Implementation>({
    {"point", kPoint},
    {"distant", kDistant},
    {"infinite", kInfinite},
    {"goniometric", {}, pbrt_only},
    {"projection", {}, pbrt_only},
    {"spot", {}, pbrt_only},
});
constexpr ImplementationTable kLightTable = {"light source", kLights};

// --- Shape

constexpr ParameterSpec kIndices = {.name = "indices", .kind = integer, .count = 0};
constexpr ParameterSpec kPositions = {.name = "P", .kind = point3, .count = 0};
constexpr ParameterSpec kNormals = {.name = "N", .kind = normal, .count = 0};
constexpr ParameterSpec kTextureCoordinates = {.name = "uv", .kind = point2, .count = 0};
constexpr ParameterSpec kAlpha = {.name = "alpha", .support = pbrt_only};
constexpr ParameterSpec kFaceIndices = {.name = "faceIndices", .support = pbrt_only};

constexpr auto kTriangleMesh = std::to_array<ParameterSpec>({
    kIndices,
    kPositions,
    kNormals,
    {.name = "S", .kind = vector3, .count = 0},
    kTextureCoordinates,
    kFaceIndices,
    kAlpha,
});
constexpr auto kBilinearMesh = std::to_array<ParameterSpec>({
    kIndices,
    kPositions,
    kNormals,
    kTextureCoordinates,
    kFaceIndices,
    {.name = "emissionfilename", .support = pbrt_only},
    kAlpha,
});
constexpr auto kSphere = std::to_array<ParameterSpec>({{.name = "radius", .range = positive},
                                                       {.name = "zmin"},
                                                       {.name = "zmax"},
                                                       {.name = "phimax", .only = 360.0},
                                                       kAlpha});
constexpr auto kShapes = std::to_array<Implementation>({
    {"trianglemesh", kTriangleMesh},
    {"bilinearmesh", kBilinearMesh},
    {"sphere", kSphere},
    {"curve", {}, pbrt_only},
    {"cylinder", {}, pbrt_only},
    {"disk", {}, pbrt_only},
    {"loopsubdiv", {}, pbrt_only},
    {"plymesh", {}, pbrt_only},
});
constexpr ImplementationTable kShapeTable = {"shape", kShapes};

}  // namespace

const ImplementationTable& material_table() noexcept { return kMaterialTable; }
const ImplementationTable& area_light_table() noexcept { return kAreaLightTable; }
const ImplementationTable& light_table() noexcept { return kLightTable; }
const ImplementationTable& shape_table() noexcept { return kShapeTable; }

}  // namespace emulsion
