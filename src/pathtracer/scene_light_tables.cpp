// The tables of LightSource and AreaLightSource.
#include <array>

#include "pathtracer/scene_tables.h"

namespace emulsion {

namespace {

using enum ValueKind;
using enum ValueRange;
using enum Support;

constexpr ParameterSpec kRadiance = {.name = "L", .kind = spectrum};
constexpr ParameterSpec kIntensity = {.name = "I", .kind = spectrum};
constexpr ParameterSpec kScale = {.name = "scale", .range = not_negative};
constexpr ParameterSpec kPower = {.name = "power"};
constexpr ParameterSpec kIlluminance = {.name = "illuminance"};
constexpr ParameterSpec kFrom = {.name = "from", .kind = point3};
constexpr ParameterSpec kTo = {.name = "to", .kind = point3};

constexpr auto kDiffuseLight = std::to_array<ParameterSpec>(
    {kRadiance, kScale, kPower, {.name = "twosided", .kind = boolean}, {.name = "filename", .support = pbrt_only}});
constexpr auto kAreaLights = std::to_array<Implementation>({{"diffuse", kDiffuseLight}});
constexpr ImplementationTable kAreaLightTable = {"area light", kAreaLights};

constexpr auto kPoint = std::to_array<ParameterSpec>({kIntensity, kScale, kPower, kFrom});
constexpr auto kSpot = std::to_array<ParameterSpec>({
    kIntensity,
    kScale,
    kPower,
    kFrom,
    kTo,
    {.name = "coneangle", .range = positive},
    {.name = "conedeltaangle", .range = not_negative},
});
constexpr auto kDistant = std::to_array<ParameterSpec>({kRadiance, kScale, kIlluminance, kFrom, kTo});
constexpr auto kInfinite = std::to_array<ParameterSpec>({
    kRadiance,
    kScale,
    kIlluminance,
    {.name = "filename", .kind = string},
    {.name = "portal", .support = pbrt_only},
});
constexpr auto kLights = std::to_array<Implementation>({
    {"point", kPoint},
    {"spot", kSpot},
    {"distant", kDistant},
    {"infinite", kInfinite},
    {"goniometric", {}, pbrt_only},
    {"projection", {}, pbrt_only},
});
constexpr ImplementationTable kLightTable = {"light source", kLights};

}  // namespace

const ImplementationTable& area_light_table() noexcept { return kAreaLightTable; }
const ImplementationTable& light_table() noexcept { return kLightTable; }

}  // namespace emulsion
