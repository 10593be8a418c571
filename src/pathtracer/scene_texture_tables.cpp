// The tables of Texture: of numbers ("float") and of reflectances ("spectrum").
#include <array>

#include "pathtracer/scene_tables.h"

namespace emulsion {

namespace {

using enum ValueKind;
using enum Support;

// --- Where on the texture a point lies

constexpr auto kMappings = std::to_array<KnownName>({{"uv"}, {"spherical"}, {"cylindrical"}, {"planar"}});
constexpr ParameterSpec kMapping = {.name = "mapping", .kind = string, .choices = kMappings};
constexpr ParameterSpec kScaleU = {.name = "uscale"};
constexpr ParameterSpec kScaleV = {.name = "vscale"};
constexpr ParameterSpec kDeltaU = {.name = "udelta"};
constexpr ParameterSpec kDeltaV = {.name = "vdelta"};
constexpr ParameterSpec kAlongU = {.name = "v1", .kind = vector3};
constexpr ParameterSpec kAlongV = {.name = "v2", .kind = vector3};

// --- Classes of both kinds

constexpr auto kFilters = std::to_array<KnownName>({{"bilinear"}, {"point"}, {"trilinear"}, {"EWA"}, {"ewa"}});
constexpr auto kWraps = std::to_array<KnownName>({{"repeat"}, {"black"}, {"clamp"}, {"octahedralsphere"}});
constexpr auto kImagemap = std::to_array<ParameterSpec>({
    {.name = "filename", .kind = string},
    {.name = "filter", .kind = string, .choices = kFilters},
    {.name = "wrap", .kind = string, .choices = kWraps},
    {.name = "maxanisotropy"},
    {.name = "scale"},
    {.name = "invert", .kind = boolean},
    {.name = "encoding", .kind = string},
    kMapping,
    kScaleU,
    kScaleV,
    kDeltaU,
    kDeltaV,
    kAlongU,
    kAlongV,
});

/// Of a kind whose values are `values`.
template <ValueKind Values, ValueKind Constant>
struct Classes {
    static constexpr auto kConstant = std::to_array<ParameterSpec>({{.name = "value", .kind = Constant}});
    static constexpr auto kScale = std::to_array<ParameterSpec>({
        {.name = "tex", .kind = Values},
        {.name = "scale", .kind = real_or_texture},
    });
    static constexpr auto kMix = std::to_array<ParameterSpec>({
        {.name = "tex1", .kind = Values},
        {.name = "tex2", .kind = Values},
        {.name = "amount", .kind = real_or_texture},
    });
    static constexpr auto kCheckerboard = std::to_array<ParameterSpec>({
        {.name = "tex1", .kind = Values},
        {.name = "tex2", .kind = Values},
        {.name = "dimension", .kind = integer},
        kMapping,
        kScaleU,
        kScaleV,
        kDeltaU,
        kDeltaV,
        kAlongU,
        kAlongV,
    });
};
using Floats = Classes<real_or_texture, real>;
using Reflectances = Classes<spectrum_or_texture, spectrum>;

constexpr auto kFloats = std::to_array<Implementation>({
    {"constant", Floats::kConstant},
    {"scale", Floats::kScale},
    {"mix", Floats::kMix},
    {"imagemap", kImagemap},
    {"checkerboard", Floats::kCheckerboard},
    {"bilerp", {}, pbrt_only},
    {"directionmix", {}, pbrt_only},
    {"dots", {}, pbrt_only},
    {"fbm", {}, pbrt_only},
    {"ptex", {}, pbrt_only},
    {"windy", {}, pbrt_only},
    {"wrinkled", {}, pbrt_only},
});
constexpr ImplementationTable kFloatTable = {"float texture", kFloats};

constexpr auto kReflectances = std::to_array<Implementation>({
    {"constant", Reflectances::kConstant},
    {"scale", Reflectances::kScale},
    {"mix", Reflectances::kMix},
    {"imagemap", kImagemap},
    {"checkerboard", Reflectances::kCheckerboard},
    {"bilerp", {}, pbrt_only},
    {"directionmix", {}, pbrt_only},
    {"dots", {}, pbrt_only},
    {"marble", {}, pbrt_only},
    {"ptex", {}, pbrt_only},
});
constexpr ImplementationTable kReflectanceTable = {"spectrum texture", kReflectances};

}  // namespace

const ImplementationTable& float_texture_table() noexcept { return kFloatTable; }
const ImplementationTable& reflectance_texture_table() noexcept { return kReflectanceTable; }

}  // namespace emulsion
