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

#include "pathtracer/scene_transform.h"

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

/// \throws SceneError unless products and quotients of a few such numbers stay finite and above 0.
double checked_exposure(const SourcePlace& place, double value, std::string_view what, std::string_view expected) {
    using Float = std::numeric_limits<float>;
    if (value >= Float::min() && value <= Float::max()) return value;
    throw SceneError(place, fmt::format("{} {}", what, value), std::string(expected));
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

/// Whether four numbers x0, x1, y0, y1 are an area within these bounds.
bool is_area(const std::vector<double>& numbers, double width, double height) noexcept {
    return numbers[0] < numbers[1] && numbers[1] <= width && numbers[2] < numbers[3] && numbers[3] <= height;
}

void read_crop(const ParameterList& list, FilmSettings& film) {
    const SceneParameter* const window = find_parameter(list, "cropwindow");
    const SceneParameter* const bounds = find_parameter(list, "pixelbounds");
    if (window != nullptr && bounds != nullptr) {
        throw SceneError(bounds->place, R"("pixelbounds" beside "cropwindow")", "one of the two");
    }
    if (window != nullptr) {
        const std::vector<double>& n = window->numbers;
        if (!is_area(n, 1.0, 1.0)) {
            throw SceneError(window->first_value, fmt::format("a crop window of {}", fmt::join(n, " ")),
                             "x0 < x1 and y0 < y1, in this order, from 0 to 1");
        }
        film.crop_window = {n[0], n[1], n[2], n[3]};
    }
    if (bounds != nullptr) {
        const std::vector<double>& n = bounds->numbers;
        if (!is_area(n, film.width_px, film.height_px)) {
            throw SceneError(
                bounds->first_value, fmt::format("pixel bounds of {}", fmt::join(n, " ")),
                fmt::format("x0 < x1 <= {} and y0 < y1 <= {}, in this order", film.width_px, film.height_px));
        }
        film.pixel_bounds = {static_cast<int>(n[0]), static_cast<int>(n[2]), static_cast<int>(n[1]),
                             static_cast<int>(n[3])};
    }
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
    return IndependentSampler{
        integer_up_to(kMostSamples, list, "pixelsamples", IndependentSampler{}.samples_per_pixel)};
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

}  // namespace

Camera read_camera(const ParameterList& list, const Imath::M44d& camera_from_world, double& exposure_time_s) {
    check_parameters(camera_table(), list);
    PerspectiveCamera camera;
    const std::optional<Imath::M44d> inverse = inverse_of(camera_from_world);
    if (!inverse) throw SceneError(list.place, "a camera under a transformation without inverse", "another one");
    camera.world_from_camera = *inverse;
    const Imath::V3d position = inverse->translation();
    if (!is_within_reach(position)) {
        throw SceneError(list.place, fmt::format("a camera at ({:g}, {:g}, {:g})", position.x, position.y, position.z),
                         std::string(kWithinReach));
    }
    camera.fov_deg = real_or(list, "fov", camera.fov_deg);
    if (!(camera.fov_deg < 180.0)) {
        throw SceneError(find_parameter(list, "fov")->first_value, fmt::format("a field of view of {}", camera.fov_deg),
                         "an angle above 0 and below 180 degrees");
    }
    if (find_parameter(list, "frameaspectratio") != nullptr) {
        camera.screen.frame_aspect_ratio = real_or(list, "frameaspectratio", 1.0);
    }
    if (const SceneParameter* const window = find_parameter(list, "screenwindow")) {
        auto& values = camera.screen.bounds.emplace();
        std::copy_n(window->numbers.begin(), values.size(), values.begin());
        if (values[0] == values[1] || values[2] == values[3]) {
            throw SceneError(window->first_value, "a screen window without area", "x min, x max, y min, y max");
        }
    }
    const double time_s = real_or(list, "shutterclose", 1.0) - real_or(list, "shutteropen", 0.0);
    exposure_time_s =
        checked_exposure(list.place, time_s, "an exposure time of", R"("shutterclose" after "shutteropen")");
    return camera;
}

void read_film(const ParameterList& list, FilmSettings& film) {
    check_parameters(film_table(), list);
    film = {};
    film.width_px = integer_up_to(kMostPixels, list, "xresolution", film.width_px);
    film.height_px = integer_up_to(kMostPixels, list, "yresolution", film.height_px);
    const std::int64_t pixels = std::int64_t{film.width_px} * film.height_px;
    if (pixels > std::numeric_limits<int>::max()) {
        throw SceneError(list.place, fmt::format("{} x {} pixels", film.width_px, film.height_px),
                         fmt::format("at most {} in all", std::numeric_limits<int>::max()));
    }
    read_crop(list, film);
    film.filename = string_or(list, "filename", "");
    film.pixel_type = flag_or(list, "savefp16", Flag::off) == Flag::on ? PixelType::half : PixelType::float32;
    film.sensor.iso = checked_exposure(list.place, real_or(list, "iso", 100.0), "an ISO speed of",
                                       "a number that single precision holds");
    film.sensor.white_balance = read_white_balance(list);
}

void check_sensor(const SourcePlace& place, const SensorOptions& sensor) {
    const double ratio = imaging_ratio(sensor);
    if (ratio >= kMinImagingRatio && ratio <= kMaxImagingRatio) return;
    throw SceneError(place, fmt::format("a scene whose exposure time times ISO / 100 is {:g}", ratio),
                     fmt::format("from {:g} to {:g}", kMinImagingRatio, kMaxImagingRatio));
}

void read_sampler(const ParameterList& list, Sampler& sampler, int& seed) {
    check_parameters(sampler_table(), list);
    sampler = supported_row<SamplerReader>(list.place, {"sampler"}, list.owner, kSamplerReaders).read(list);
    seed = integer_or(list, "seed", 0);
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

PathIntegratorSettings read_integrator(const ParameterList& list) {
    check_parameters(integrator_table(), list);
    return {integer_or(list, "maxdepth", PathIntegratorSettings{}.max_depth)};
}

}  // namespace emulsion
