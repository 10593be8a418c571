#include "pathtracer/scene_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace emulsion {

namespace {

/// A filter parameter, which must also be fit for single precision.
float filter_number(const ParameterList& list, std::string_view name, float otherwise) {
    const SceneParameter* const parameter = find_parameter(list, name);
    if (parameter == nullptr) return otherwise;
    const auto value = static_cast<float>(parameter->numbers.front());
    const bool kept = std::isfinite(value) && (value != 0.0f || parameter->numbers.front() == 0.0);
    if (kept) return value;
    throw SceneError(parameter->first_value, fmt::format(R"({} for parameter "{}")", parameter->numbers.front(), name),
                     "a number that single precision holds");
}

constexpr int kMostSamples = 1 << 24;  // as RenderOptions
constexpr int kMostPixels = 65536;     // of a side; as FilmOptions

/// \throws SceneError if a parameter is above what the renderer takes.
int integer_up_to(int most, const ParameterList& list, std::string_view name, int otherwise) {
    const int value = integer_or(list, name, otherwise);
    if (value <= most) return value;
    throw SceneError(find_parameter(list, name)->first_value, fmt::format(R"({} for parameter "{}")", value, name),
                     fmt::format("at most {}", most));
}

/// None where the scene gives none, or 0.
std::optional<WhiteBalance> read_white_balance(const ParameterList& list) {
    const SceneParameter* const parameter = find_parameter(list, "whitebalance");
    if (parameter == nullptr || parameter->numbers.front() == 0.0) return std::nullopt;
    const double nominal_K = parameter->numbers.front();
    WhiteBalance balance{TemperatureWhite{daylight_temperature_of_nominal(nominal_K)}};
    try {
        validate(balance);
    } catch (const std::invalid_argument&) {
        throw SceneError(parameter->first_value, fmt::format(R"({} for parameter "whitebalance")", nominal_K),
                         "a colour temperature from 1000 to 24986 K, or 0 for no white balance");
    }
    return balance;
}

/// Two numbers in rising order, brought into [0, most].
std::array<double, 2> range_of(double a, double b, double most) noexcept {
    const auto [low, high] = std::minmax(a, b);
    return {std::clamp(low, 0.0, most), std::clamp(high, 0.0, most)};
}

/// As pbrt-v4 reads four numbers x0, x1, y0, y1: in any order, and cut off at the frame's sides.
/// \throws SceneError if nothing is left.
std::array<double, 4> read_area(const SceneParameter& parameter, double width, double height, SceneWarnings& warnings) {
    const std::vector<double>& n = parameter.numbers;
    const auto [x0, x1] = range_of(n[0], n[1], width);
    const auto [y0, y1] = range_of(n[2], n[3], height);
    if (!(x0 < x1) || !(y0 < y1)) {
        throw SceneError(parameter.first_value, fmt::format("a {} of {}", parameter.name, fmt::join(n, " ")),
                         fmt::format("x0 < x1 and y0 < y1, in this order, from 0 to {:g} and to {:g}", width, height));
    }
    const std::array<double, 4> area = {x0, x1, y0, y1};
    if (!std::equal(area.begin(), area.end(), n.begin())) {
        warnings.add(parameter.first_value, fmt::format("\"{}\" [ {} ] is taken as {}", parameter.name,
                                                        fmt::join(n, " "), fmt::join(area, " ")));
    }
    return area;
}

void read_crop(const ParameterList& list, FilmSettings& film, SceneWarnings& warnings) {
    const SceneParameter* const window = find_parameter(list, "cropwindow");
    const SceneParameter* const bounds = find_parameter(list, "pixelbounds");
    if (window != nullptr) film.crop_window = read_area(*window, 1.0, 1.0, warnings);
    if (bounds == nullptr) return;
    if (window != nullptr) return warnings.add(bounds->place, R"("pixelbounds" have no effect beside "cropwindow")");
    const std::array<double, 4> n = read_area(*bounds, film.width_px, film.height_px, warnings);
    film.pixel_bounds = {static_cast<int>(n[0]), static_cast<int>(n[2]), static_cast<int>(n[1]),
                         static_cast<int>(n[3])};
}

template <class T>
T with_radii(const ParameterList& list, T filter) {
    filter.x_radius_px = filter_number(list, "xradius", filter.x_radius_px);
    filter.y_radius_px = filter_number(list, "yradius", filter.y_radius_px);
    return filter;
}

Filter read_box(const ParameterList& list) { return with_radii(list, BoxFilter{}); }
Filter read_triangle(const ParameterList& list) { return with_radii(list, TriangleFilter{}); }
Filter read_gaussian(const ParameterList& list) {
    auto filter = with_radii(list, GaussianFilter{});
    filter.sigma_px = filter_number(list, "sigma", filter.sigma_px);
    return filter;
}
Filter read_mitchell(const ParameterList& list) {
    auto filter = with_radii(list, MitchellFilter{});
    filter.b = filter_number(list, "B", filter.b);
    filter.c = filter_number(list, "C", filter.c);
    return filter;
}
Filter read_catmull_rom(const ParameterList& list) { return with_radii(list, CatmullRomFilter{}); }
Filter read_blackman_harris(const ParameterList& list) { return with_radii(list, BlackmanHarrisFilter{}); }
Filter read_sinc(const ParameterList& list) {
    auto filter = with_radii(list, LanczosSincFilter{});
    filter.tau = filter_number(list, "tau", filter.tau);
    return filter;
}

struct FilterReader {
    std::string_view name;
    Filter (*read)(const ParameterList&);
};
constexpr auto kFilterReaders = std::to_array<FilterReader>({{BoxFilter::kName, read_box},
                                                             {TriangleFilter::kName, read_triangle},
                                                             {GaussianFilter::kName, read_gaussian},
                                                             {MitchellFilter::kName, read_mitchell},
                                                             {CatmullRomFilter::kName, read_catmull_rom},
                                                             {BlackmanHarrisFilter::kName, read_blackman_harris},
                                                             {LanczosSincFilter::kName, read_sinc}});

Sampler read_independent(const ParameterList& list) {
    constexpr int kDefaultOfPbrt = 4;  // unlike the other samplers'
    return IndependentSampler{integer_up_to(kMostSamples, list, "pixelsamples", kDefaultOfPbrt)};
}
Sampler read_padded_sobol(const ParameterList& list) {
    return PaddedSobolSampler{
        integer_up_to(kMostSamples, list, "pixelsamples", PaddedSobolSampler{}.samples_per_pixel)};
}
Sampler read_stratified(const ParameterList& list) {
    StratifiedSampler sampler;
    sampler.x_samples = integer_or(list, "xsamples", sampler.x_samples);
    sampler.y_samples = integer_or(list, "ysamples", sampler.y_samples);
    sampler.jitter = flag_or(list, "jitter", Flag::on) == Flag::on;
    const std::int64_t samples = std::int64_t{sampler.x_samples} * sampler.y_samples;
    if (samples > kMostSamples) {
        throw SceneError(list.place, fmt::format("{} x {} samples", sampler.x_samples, sampler.y_samples),
                         fmt::format("at most {} in all", kMostSamples));
    }
    return sampler;
}

struct SamplerReader {
    std::string_view name;
    Sampler (*read)(const ParameterList&);
};
constexpr auto kSamplerReaders = std::to_array<SamplerReader>(
    {{"independent", read_independent}, {"paddedsobol", read_padded_sobol}, {"stratified", read_stratified}});

/// Radiance in buckets of wavelengths, of film "spectral".
SpectralBuckets read_buckets(const ParameterList& list) {
    const SpectralBuckets buckets{integer_or(list, "nbuckets", 16), real_or(list, "lambdamin", kMinWavelength_nm),
                                  real_or(list, "lambdamax", kMaxWavelength_nm)};
    if (buckets.min_nm < kMinWavelength_nm || buckets.max_nm > kMaxWavelength_nm) {
        throw SceneError(
            list.place, fmt::format("wavelengths from {:g} to {:g} nm", buckets.min_nm, buckets.max_nm),
            fmt::format("some of those that paths have, from {} to {} nm", kMinWavelength_nm, kMaxWavelength_nm));
    }
    try {
        validate(buckets);
    } catch (const std::invalid_argument& error) {
        throw SceneError(list.place, fmt::format("buckets of wavelengths that can't be ({})", error.what()),
                         "\"lambdamin\" below \"lambdamax\", and from 1 to 1024 \"nbuckets\" between them");
    }
    return buckets;
}

/// What is said of an implementation that another stands for, and of the list's parameters without effect.
std::string taken_as_warning(const ImplementationTable& table, const Implementation& given, const ParameterList& list) {
    std::vector<std::string> ignored;
    for (const ParameterSpec& spec : given.parameters) {
        if (spec.is_ignored && find_parameter(list, spec.name) != nullptr) ignored.push_back(quote(spec.name));
    }
    std::string warning = fmt::format("{} {} is taken as {}: the same picture with other noise", table.noun,
                                      quote(given.name), quote(given.taken_as));
    if (!ignored.empty()) warning += fmt::format("; of no effect: {}", fmt::join(ignored, ", "));
    return warning;
}

}  // namespace

double checked_exposure(const SourcePlace& place, double value, std::string_view what, std::string_view expected) {
    using Float = std::numeric_limits<float>;
    if (value >= Float::min() && value <= Float::max()) return value;
    throw SceneError(place, fmt::format("{} {}", what, value), std::string(expected));
}

void read_film(const ParameterList& list, FilmSettings& film, SceneWarnings& warnings) {
    const Implementation& given = check_parameters(film_table(), list);
    if (!given.taken_as.empty()) {
        warnings.add(list.place, fmt::format("film {} is taken as {}: the same picture without layers of its own",
                                             quote(given.name), quote(given.taken_as)));
    }
    film = {};
    film.width_px = integer_up_to(kMostPixels, list, "xresolution", film.width_px);
    film.height_px = integer_up_to(kMostPixels, list, "yresolution", film.height_px);
    const std::int64_t pixels = std::int64_t{film.width_px} * film.height_px;
    if (pixels > std::numeric_limits<int>::max()) {
        throw SceneError(list.place, fmt::format("{} x {} pixels", film.width_px, film.height_px),
                         fmt::format("at most {} in all", std::numeric_limits<int>::max()));
    }
    read_crop(list, film, warnings);
    film.filename = string_or(list, "filename", "");
    film.pixel_type = flag_or(list, "savefp16", Flag::off) == Flag::on ? PixelType::half : PixelType::float32;
    film.sensor.iso = checked_exposure(list.place, real_or(list, "iso", 100.0), "an ISO speed of",
                                       "a number that single precision holds");
    film.sensor.white_balance = read_white_balance(list);
    if (list.owner == "spectral") film.spectrum = read_buckets(list);
}

void check_sensor(const SourcePlace& place, const SensorOptions& sensor) {
    const double ratio = imaging_ratio(sensor);
    if (ratio >= kMinImagingRatio && ratio <= kMaxImagingRatio) return;
    throw SceneError(place, fmt::format("a scene whose exposure time times ISO / 100 is {:g}", ratio),
                     fmt::format("from {:g} to {:g}", kMinImagingRatio, kMaxImagingRatio));
}

ReadSampler read_sampler(const ParameterList& list) {
    const Implementation& given = check_parameters(sampler_table(), list);
    ReadSampler read;
    const std::string_view taken_as = given.taken_as.empty() ? given.name : given.taken_as;
    read.sampler = supported_row<SamplerReader>(list.place, {"sampler"}, taken_as, kSamplerReaders).read(list);
    if (find_parameter(list, "seed") != nullptr) read.seed = integer_or(list, "seed", 0);
    const std::string randomization = string_or(list, "randomization", "owen");
    if (!given.taken_as.empty()) {
        read.warning = taken_as_warning(sampler_table(), given, list);
    } else if (randomization != "owen" && randomization != "fastowen") {
        read.warning =
            fmt::format("randomization {} of sampler {} is taken as \"owen\"", quote(randomization), quote(given.name));
    }
    return read;
}

Filter read_filter(const ParameterList& list) {
    check_parameters(filter_table(), list);
    const Filter filter =
        supported_row<FilterReader>(list.place, {"pixel filter"}, list.owner, kFilterReaders).read(list);
    try {
        validate(filter);
    } catch (const std::invalid_argument& error) {
        throw SceneError(list.place, fmt::format("a pixel filter that can't be normalised ({})", error.what()),
                         "one with a positive integral");
    }
    return filter;
}

ReadIntegrator read_integrator(const ParameterList& list) {
    const Implementation& given = check_parameters(integrator_table(), list);
    ReadIntegrator read;
    read.settings.max_depth = integer_or(list, "maxdepth", read.settings.max_depth);
    if (!given.taken_as.empty()) read.warning = taken_as_warning(integrator_table(), given, list);
    return read;
}

}  // namespace emulsion
