// The tables of Shape.
#include <array>

#include "pathtracer/scene_tables.h"

namespace emulsion {

namespace {

using enum ValueKind;
using enum ValueRange;
using enum Support;

constexpr ParameterSpec kIndices = {.name = "indices", .kind = integer, .count = 0};
constexpr ParameterSpec kPositions = {.name = "P", .kind = point3, .count = 0};
constexpr ParameterSpec kNormals = {.name = "N", .kind = normal, .count = 0};
constexpr ParameterSpec kTextureCoordinates = {.name = "uv", .kind = point2, .count = 0};
constexpr ParameterSpec kAlpha = {.name = "alpha", .only = 1.0};
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
constexpr auto kPlyMesh = std::to_array<ParameterSpec>({
    {.name = "filename", .kind = string},
    {.name = "displacement", .support = pbrt_only},
    {.name = "edgelength", .support = pbrt_only},
    kAlpha,
});
constexpr auto kSphere = std::to_array<ParameterSpec>(
    {{.name = "radius", .range = positive}, {.name = "zmin"}, {.name = "zmax"}, {.name = "phimax"}, kAlpha});
constexpr auto kDisk = std::to_array<ParameterSpec>({{.name = "radius", .range = positive},
                                                     {.name = "innerradius", .range = not_negative},
                                                     {.name = "height"},
                                                     {.name = "phimax"},
                                                     kAlpha});
constexpr auto kCylinder = std::to_array<ParameterSpec>(
    {{.name = "radius", .range = positive}, {.name = "zmin"}, {.name = "zmax"}, {.name = "phimax"}, kAlpha});
constexpr auto kShapes = std::to_array<Implementation>({
    {"trianglemesh", kTriangleMesh},
    {"bilinearmesh", kBilinearMesh},
    {"plymesh", kPlyMesh},
    {"sphere", kSphere},
    {"disk", kDisk},
    {"cylinder", kCylinder},
    {"curve", {}, pbrt_only},
    {.name = "loopsubdiv",
     .support = pbrt_only,
     .advice = "surfaces are not subdivided here: its control cage, the \"indices\" and \"P\", can be given as a "
               "\"trianglemesh\""},
});
constexpr ImplementationTable kShapeTable = {"shape", kShapes};

}  // namespace

const ImplementationTable& shape_table() noexcept { return kShapeTable; }

}  // namespace emulsion
