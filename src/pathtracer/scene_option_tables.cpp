// The tables of what may stand before WorldBegin.
#include <array>

#include "pathtracer/scene_tables.h"

namespace emulsion {

namespace {

using enum ValueKind;
using enum ValueRange;
using enum Support;

// --- Camera

constexpr ParameterSpec kAspect = {.name = "frameaspectratio", .range = positive};
constexpr ParameterSpec kScreenWindow = {.name = "screenwindow", .count = 4};
constexpr ParameterSpec kLensRadius = {.name = "lensradius", .range = not_negative};
constexpr ParameterSpec kFocalDistance = {.name = "focaldistance", .range = positive};
constexpr ParameterSpec kShutterOpen = {.name = "shutteropen"};
constexpr ParameterSpec kShutterClose = {.name = "shutterclose"};
constexpr auto kPerspective = std::to_array<ParameterSpec>({{.name = "fov", .range = positive},
                                                            kAspect,
                                                            kScreenWindow,
                                                            kLensRadius,
                                                            kFocalDistance,
                                                            kShutterOpen,
                                                            kShutterClose});
constexpr auto kOrthographic =
    std::to_array<ParameterSpec>({kAspect, kScreenWindow, kLensRadius, kFocalDistance, kShutterOpen, kShutterClose});
constexpr auto kMappings = std::to_array<KnownName>({{"equalarea"}, {"equirectangular"}});
// pbrt-v4 reads window and lens of this camera, too, and does nothing with them.
constexpr auto kSpherical = std::to_array<ParameterSpec>({{.name = "mapping", .kind = string, .choices = kMappings},
                                                          kAspect,
                                                          kScreenWindow,
                                                          kLensRadius,
                                                          kFocalDistance,
                                                          kShutterOpen,
                                                          kShutterClose});
constexpr auto kCameras = std::to_array<Implementation>({{"perspective", kPerspective},
                                                         {"orthographic", kOrthographic},
                                                         {"spherical", kSpherical},
                                                         {"realistic", {}, pbrt_only}});
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
constexpr ParameterSpec kXResolution = {.name = "xresolution", .kind = integer, .range = positive};
constexpr ParameterSpec kYResolution = {.name = "yresolution", .kind = integer, .range = positive};
constexpr ParameterSpec kFilename = {.name = "filename", .kind = string};
constexpr ParameterSpec kSaveHalf = {.name = "savefp16", .kind = boolean};
constexpr ParameterSpec kSensor = {.name = "sensor", .kind = string, .choices = kSensors};
constexpr ParameterSpec kIso = {.name = "iso", .range = positive};
constexpr ParameterSpec kDiagonal = {.name = "diagonal", .range = positive};  // of the "realistic" camera only
constexpr ParameterSpec kCropWindow = {.name = "cropwindow", .count = 4};
constexpr ParameterSpec kPixelBounds = {.name = "pixelbounds", .kind = integer, .count = 4};
constexpr ParameterSpec kWhiteBalance = {.name = "whitebalance", .range = not_negative};
constexpr ParameterSpec kMaxComponent = {.name = "maxcomponentvalue", .support = pbrt_only};
constexpr auto kRgbFilm =
    std::to_array<ParameterSpec>({kXResolution, kYResolution, kFilename, kSaveHalf, kSensor, kIso, kDiagonal,
                                  kCropWindow, kPixelBounds, kWhiteBalance, kMaxComponent});
constexpr auto kSpectralFilm = std::to_array<ParameterSpec>({kXResolution,
                                                             kYResolution,
                                                             kFilename,
                                                             kSaveHalf,
                                                             kSensor,
                                                             kIso,
                                                             kDiagonal,
                                                             kCropWindow,
                                                             kPixelBounds,
                                                             kWhiteBalance,
                                                             {.name = "nbuckets", .kind = integer, .range = positive},
                                                             {.name = "lambdamin", .range = positive},
                                                             {.name = "lambdamax", .range = positive},
                                                             kMaxComponent});
constexpr auto kGeometryFilm =
    std::to_array<ParameterSpec>({kXResolution,
                                  kYResolution,
                                  kFilename,
                                  kSaveHalf,
                                  kSensor,
                                  kIso,
                                  kDiagonal,
                                  kCropWindow,
                                  kPixelBounds,
                                  kWhiteBalance,
                                  {.name = "coordinatesystem", .kind = string, .is_ignored = true},
                                  kMaxComponent});
constexpr auto kFilms =
    std::to_array<Implementation>({{"rgb", kRgbFilm},
                                   {"spectral", kSpectralFilm},
                                   {.name = "gbuffer", .parameters = kGeometryFilm, .taken_as = "rgb"}});
constexpr ImplementationTable kFilmTable = {"film", kFilms};

// --- Sampler

// All are Owen's scrambling to us: pbrt's "fastowen" is a quicker hash for the same thing, the others are said to be
// taken so.
constexpr auto kRandomizations = std::to_array<KnownName>({{"owen"}, {"fastowen"}, {"none"}, {"permutedigits"}});
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
    {kSamples, kSeed, {.name = "randomization", .kind = string, .choices = kRandomizations, .is_ignored = true}});
constexpr auto kSamplers = std::to_array<Implementation>({
    {"independent", kIndependent},
    {"stratified", kStratified},
    {"paddedsobol", kPaddedSobol},
    {.name = "halton", .parameters = kPaddedSobol, .taken_as = "paddedsobol"},
    {.name = "sobol", .parameters = kPaddedSobol, .taken_as = "paddedsobol"},
    {.name = "zsobol", .parameters = kPaddedSobol, .taken_as = "paddedsobol"},
    {.name = "pmj02bn", .parameters = kIndependent, .taken_as = "paddedsobol"},
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
constexpr ParameterSpec kMaxDepth = {.name = "maxdepth", .kind = integer, .range = not_negative};
constexpr ParameterSpec kLightSampler = {
    .name = "lightsampler", .kind = string, .choices = kLightSamplers, .is_ignored = true};
constexpr ParameterSpec kRegularize = {.name = "regularize", .kind = boolean, .only = 0.0};
constexpr auto kPath = std::to_array<ParameterSpec>({kMaxDepth, kLightSampler, kRegularize});
constexpr auto kSimplePath =
    std::to_array<ParameterSpec>({kMaxDepth,
                                  {.name = "samplelights", .kind = boolean, .is_ignored = true},
                                  {.name = "samplebsdf", .kind = boolean, .is_ignored = true}});
constexpr auto kSimpleVolumePath = std::to_array<ParameterSpec>({kMaxDepth});
constexpr auto kBidirectional =
    std::to_array<ParameterSpec>({kMaxDepth,
                                  kRegularize,
                                  {.name = "visualizestrategies", .kind = boolean, .only = 0.0},
                                  {.name = "visualizeweights", .kind = boolean, .only = 0.0}});
constexpr auto kMetropolis = std::to_array<ParameterSpec>({
    kMaxDepth,
    kRegularize,
    {.name = "bootstrapsamples", .kind = integer, .range = positive, .is_ignored = true},
    {.name = "chains", .kind = integer, .range = positive, .is_ignored = true},
    {.name = "mutationsperpixel", .kind = integer, .range = positive, .is_ignored = true},
    {.name = "largestepprobability", .range = not_negative, .is_ignored = true},
    {.name = "sigma", .range = positive, .is_ignored = true},
});
// Without media they all compute the same picture but for their noise. The others don't.
constexpr auto kIntegrators = std::to_array<Implementation>({
    {"path", kPath},
    {.name = "volpath", .parameters = kPath, .taken_as = "path"},
    {.name = "simplepath", .parameters = kSimplePath, .taken_as = "path"},
    {.name = "simplevolpath", .parameters = kSimpleVolumePath, .taken_as = "path"},
    {.name = "bdpt", .parameters = kBidirectional, .taken_as = "path"},
    {.name = "mlt", .parameters = kMetropolis, .taken_as = "path"},
    {"ambientocclusion", {}, pbrt_only},
    {"function", {}, pbrt_only},
    {"lightpath", {}, pbrt_only},
    {"randomwalk", {}, pbrt_only},
    {"sppm", {}, pbrt_only},
});
constexpr ImplementationTable kIntegratorTable = {"integrator", kIntegrators};

// --- Accelerator: checked, and of no effect

constexpr auto kSplitMethods = std::to_array<KnownName>({{"sah"}, {"middle"}, {"equal"}, {"hlbvh"}});
constexpr auto kBvh = std::to_array<ParameterSpec>(
    {{.name = "maxnodeprims", .kind = integer}, {.name = "splitmethod", .kind = string, .choices = kSplitMethods}});
constexpr auto kKdTree = std::to_array<ParameterSpec>({{.name = "intersectcost", .kind = integer},
                                                       {.name = "traversalcost", .kind = integer},
                                                       {.name = "emptybonus"},
                                                       {.name = "maxprims", .kind = integer},
                                                       {.name = "maxdepth", .kind = integer}});
constexpr auto kAccelerators = std::to_array<Implementation>({{"bvh", kBvh}, {"kdtree", kKdTree}});
constexpr ImplementationTable kAcceleratorTable = {"accelerator", kAccelerators};

}  // namespace

const ImplementationTable& camera_table() noexcept { return kCameraTable; }
const ImplementationTable& film_table() noexcept { return kFilmTable; }
const ImplementationTable& sampler_table() noexcept { return kSamplerTable; }
const ImplementationTable& filter_table() noexcept { return kFilterTable; }
const ImplementationTable& integrator_table() noexcept { return kIntegratorTable; }
const ImplementationTable& accelerator_table() noexcept { return kAcceleratorTable; }

}  // namespace emulsion
