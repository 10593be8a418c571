// The tables of what may stand before WorldBegin.
#include <array>

#include "pathtracer/scene_tables.h"

namespace emulsion {

namespace {

using enum ValueKind;
using enum ValueRange;
using enum Support;

// --- Camera

constexpr auto kPerspective = std::to_array<ParameterSpec>({
    {.name = "fov", .range = positive},
    {.name = "frameaspectratio", .range = positive},
    {.name = "screenwindow", .count = 4},
    {.name = "lensradius", .only = 0.0},
    {.name = "focaldistance", .range = positive},  // of no effect without a lens
    {.name = "shutteropen"},
    {.name = "shutterclose"},
});
constexpr auto kCameras = std::to_array<Implementation>({
    {"perspective", kPerspective},
    {"orthographic", {}, pbrt_only},
    {"realistic", {}, pbrt_only},
    {"spherical", {}, pbrt_only},
});
constexpr ImplementationTable kCameraTable = {"camera", kCameras};

// --- Film

constexpr auto kSensors = std::to_array<KnownName>({
    {"cie1931"},
    {"canon_eos_100d", pbrt_only},
    {"canon_eos_1dx_mkii", pbrt_only},
    {"canon_eos_200d", pbrt_only},
    {"canon_eos_200d_mkii", pbrt_only},
    {"canon_eos_5d", pbrt_only},
    {"canon_eos_5d_mkii", pbrt_only},
    {"canon_eos_5d_mkiii", pbrt_only},
    {"canon_eos_5d_mkiv", pbrt_only},
    {"canon_eos_5ds", pbrt_only},
    {"canon_eos_m", pbrt_only},
    {"hasselblad_l1d_20c", pbrt_only},
    {"nikon_d810", pbrt_only},
    {"nikon_d850", pbrt_only},
    {"sony_ilce_6400", pbrt_only},
    {"sony_ilce_7m3", pbrt_only},
    {"sony_ilce_7rm3", pbrt_only},
    {"sony_ilce_9", pbrt_only},
});
constexpr auto kRgbFilm = std::to_array<ParameterSpec>({
    {.name = "xresolution", .kind = integer, .range = positive},
    {.name = "yresolution", .kind = integer, .range = positive},
    {.name = "filename", .kind = string},
    {.name = "savefp16", .kind = boolean},
    {.name = "sensor", .kind = string, .choices = kSensors},
    {.name = "iso", .range = positive},
    {.name = "diagonal", .range = positive},  // of no effect on a perspective camera
    {.name = "cropwindow", .count = 4, .range = not_negative},
    {.name = "pixelbounds", .kind = integer, .count = 4, .range = not_negative},
    {.name = "whitebalance", .range = not_negative},
    {.name = "maxcomponentvalue", .support = pbrt_only},
});
constexpr auto kFilms =
    std::to_array<Implementation>({{"rgb", kRgbFilm}, {"gbuffer", {}, pbrt_only}, {"spectral", {}, pbrt_only}});
constexpr ImplementationTable kFilmTable = {"film", kFilms};

// --- Sampler

// Both are Owen's scrambling to us; pbrt's "fastowen" is a quicker hash for the same thing.
constexpr auto kRandomizations =
    std::to_array<KnownName>({{"owen"}, {"fastowen"}, {"none", pbrt_only}, {"permutedigits", pbrt_only}});
constexpr ParameterSpec kSamples = {.name = "pixelsamples", .kind = integer, .range = positive};
constexpr ParameterSpec kSeed = {.name = "seed", .kind = integer};
constexpr auto kIndependent = std::to_array<ParameterSpec>({kSamples, kSeed});
constexpr auto kStratified = std::to_array<ParameterSpec>({
    {.name = "xsamples", .kind = integer, .range = positive},
    {.name = "ysamples", .kind = integer, .range = positive},
    {.name = "jitter", .kind = boolean},
    kSeed,
});
constexpr auto kPaddedSobol = std::to_array<ParameterSpec>(
    {kSamples, kSeed, {.name = "randomization", .kind = string, .choices = kRandomizations}});
constexpr auto kSamplers = std::to_array<Implementation>({
    {"independent", kIndependent},
    {"stratified", kStratified},
    {"paddedsobol", kPaddedSobol},
    {"halton", {}, pbrt_only},
    {"pmj02bn", {}, pbrt_only},
    {"sobol", {}, pbrt_only},
    {"zsobol", {}, pbrt_only},
});
constexpr ImplementationTable kSamplerTable = {"sampler", kSamplers};

// --- PixelFilter

constexpr ParameterSpec kXRadius = {.name = "xradius", .range = positive};
constexpr ParameterSpec kYRadius = {.name = "yradius", .range = positive};
constexpr auto kRadii = std::to_array<ParameterSpec>({kXRadius, kYRadius});
constexpr auto kGaussian = std::to_array<ParameterSpec>({kXRadius, kYRadius, {.name = "sigma", .range = positive}});
constexpr auto kMitchell = std::to_array<ParameterSpec>({kXRadius, kYRadius, {.name = "B"}, {.name = "C"}});
constexpr auto kSinc = std::to_array<ParameterSpec>({kXRadius, kYRadius, {.name = "tau", .range = positive}});
constexpr auto kFilters =
    std::to_array<Implementation>({{"box", kRadii},
                                   {"triangle", kRadii},
                                   {"gaussian", kGaussian},
                                   {"mitchell", kMitchell},
                                   {"sinc", kSinc},
                                   {"catmull-rom", kRadii},
                                   {"blackman-harris", kRadii}});  // the last two are ours, and unknown to pbrt-v4
constexpr ImplementationTable kFilterTable = {"pixel filter", kFilters};

// --- Integrator

// How lights are picked changes the noise, not the picture; ours is half by power, half in equal shares to all
// lights.
constexpr auto kLightSamplers = std::to_array<KnownName>({{"bvh"}, {"uniform"}, {"power"}, {"exhaustive"}});
constexpr auto kPath = std::to_array<ParameterSpec>({
    {.name = "maxdepth", .kind = integer, .range = not_negative},
    {.name = "lightsampler", .kind = string, .choices = kLightSamplers},
    {.name = "regularize", .kind = boolean, .only = 0.0},
});
constexpr auto kIntegrators = std::to_array<Implementation>({
    {"path", kPath},
    {"ambientocclusion", {}, pbrt_only},
    {"bdpt", {}, pbrt_only},
    {"function", {}, pbrt_only},
    {"lightpath", {}, pbrt_only},
    {"mlt", {}, pbrt_only},
    {"randomwalk", {}, pbrt_only},
    {"simplepath", {}, pbrt_only},
    {"simplevolpath", {}, pbrt_only},
    {"sppm", {}, pbrt_only},
    {"volpath", {}, pbrt_only},
});
constexpr ImplementationTable kIntegratorTable = {"integrator", kIntegrators};

}  // namespace

const ImplementationTable& camera_table() noexcept { return kCameraTable; }
const ImplementationTable& film_table() noexcept { return kFilmTable; }
const ImplementationTable& sampler_table() noexcept { return kSamplerTable; }
const ImplementationTable& filter_table() noexcept { return kFilterTable; }
const ImplementationTable& integrator_table() noexcept { return kIntegratorTable; }

}  // namespace emulsion
