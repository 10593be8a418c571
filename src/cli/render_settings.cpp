#include "cli/render_settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/distinct_files.h"
#include "cli/film_files.h"
#include "cli/named_option.h"
#include "cli/pipeline_options.h"
#include "core/parameters.h"
#include "film/camera_response.h"
#include "pathtracer/sample_sequence.h"
#include "spectrum/observer.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion::cli {

namespace {

/// Refuses an option's value as bad usage, if the library would refuse it.
template <class Options>
void check_option(const char* option, const Options& options) {
    try {
        validate(options);
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError(option, error.what());
    }
}

/// The texts between separators: one more than there are of these.
std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

/// \throws CLI::ValidationError unless the text is a number and nothing else.
template <class Number>
Number number_of(std::string_view digits, const char* option, const std::string& text, const char* expected) {
    Number value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc{} && end == digits.data() + digits.size()) return value;
    throw CLI::ValidationError(option, "found \"" + text + "\", expected " + expected);
}

template <class Number, std::size_t N>
std::array<Number, N> numbers_of(const std::string& text, char separator, const char* option, const char* expected) {
    const std::vector<std::string_view> parts = split(text, separator);
    if (parts.size() != N) throw CLI::ValidationError(option, "found \"" + text + "\", expected " + expected);
    std::array<Number, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) numbers[i] = number_of<Number>(parts[i], option, text, expected);
    return numbers;
}

/// "640x480".
std::pair<int, int> parse_resolution(const std::string& text) {
    const auto [width, height] = numbers_of<int, 2>(text, 'x', "--resolution", "WIDTHxHEIGHT in pixels");
    check_option("--resolution", FilmOptions{.width_px = width, .height_px = height});
    return {width, height};
}

/// "16,8,48,24".
PixelBounds parse_crop(const std::string& text) {
    constexpr const char* kExpected = "X0,Y0,X1,Y1 in pixels, with 0 <= X0 < X1 and 0 <= Y0 < Y1";
    const auto [x0, y0, x1, y1] = numbers_of<int, 4>(text, ',', "--crop", kExpected);
    if (x0 >= 0 && y0 >= 0 && x0 < x1 && y0 < y1) return {x0, y0, x1, y1};
    throw CLI::ValidationError("--crop", "found \"" + text + "\", expected " + kExpected);
}

/// "2/8".
Shard parse_shard(const std::string& text) {
    constexpr const char* kExpected = "I/N, with 1 <= I <= N";
    const auto [number, count] = numbers_of<int, 2>(text, '/', "--shard", kExpected);
    if (number >= 1 && number <= count) return {number, count};
    throw CLI::ValidationError("--shard", "found \"" + text + "\", expected " + kExpected);
}

/// "32" or "32:380-780".
SpectralBuckets parse_spectrum(const std::string& text) {
    constexpr const char* kExpected = "N or N:MIN-MAX, a number of buckets and a range in nm";
    SpectralBuckets buckets;
    const std::size_t colon = text.find(':');
    buckets.count = number_of<int>(std::string_view(text).substr(0, colon), "--spectrum", text, kExpected);
    if (colon != std::string::npos) {
        std::tie(buckets.min_nm, buckets.max_nm) =
            std::tuple_cat(numbers_of<double, 2>(text.substr(colon + 1), '-', "--spectrum", kExpected));
    }
    check_option("--spectrum", buckets);
    return buckets;
}

/// "albedo,normal".
std::vector<AuxLayer> parse_aux(const std::string& text) {
    std::vector<AuxLayer> layers;
    try {
        for (const std::string_view name : split(text, ',')) layers.push_back(known_aux_layer(std::string(name)));
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("--aov", error.what());
    }
    check_option("--aov", FilmOptions{.aux = layers});
    return layers;
}

FilmVariance parse_variance(const std::string& text) {
    if (text == "luminance") return FilmVariance::luminance;
    if (text == "xyz") return FilmVariance::xyz;
    throw CLI::ValidationError("--variance", "found \"" + text + "\", expected luminance or xyz");
}

/// Empty if the text is one of 0, 1, ..., 2^64 - 1, else what is wrong with it.
std::string is_whole_number(const std::string& text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size()) return {};
    return "found \"" + text + "\", expected a whole number from 0 to 18446744073709551615";
}

/// A flag whose text `parse` turns into `target`.
template <class Target, class Parse>
CLI::Option* add_parsed(CLI::App& command, const char* flag, Target& target, Parse parse, const std::string& help,
                        const char* value_name) {
    return command
        .add_option_function<std::string>(
            flag, [&target, parse](const std::string& text) { target = parse(text); }, help)
        ->option_text(value_name);
}

// --- The flags by what they are about

void add_file_options(CLI::App& command, RenderSettings& settings) {
    command.add_option("SCENE", settings.scene, "Scene file in pbrt-v4 syntax")->required()->option_text(" ");
    command
        .add_option("-o,--output", settings.output,
                    "Scene-referred EXR: X Y Z, Y in cd/m^2, and the layers asked for; a name ending in .film.exr "
                    "makes it a film state, which also holds all that is needed to go on [default: the scene's film "
                    "name, ending in .exr]")
        ->check(ends_in_exr)
        ->option_text("FILE");
    command.add_option("--png", settings.png, "Also develop the picture to this 8-bit sRGB PNG [default: none]")
        ->option_text("FILE");
}

void add_sample_options(CLI::App& command, RenderSettings& settings) {
    command
        .add_option_function<int>(
            "--spp",
            [&settings](int samples) {
                check_option("--spp", RenderOptions{.samples_per_pixel = samples});
                settings.samples_per_pixel = samples;
            },
            "Samples per pixel, >= 1 [default: the scene's]")
        ->option_text("N");
    command.add_option("--seed", settings.seed, "Seed of the random numbers, >= 0 [default: the scene's, or 0]")
        ->check(is_whole_number)
        ->option_text("N");
    command
        .add_option("--wavelengths", settings.wavelengths,
                    fmt::format("Wavelengths per path, one of {} [default: {}]", fmt::join(kWavelengthCounts, ", "),
                                settings.wavelengths))
        ->check(CLI::IsMember(std::vector<int>(kWavelengthCounts.begin(), kWavelengthCounts.end())))
        ->option_text("N");
    command.add_option("--threads", settings.threads, "Threads, 0 to 1024; 0: one per processor [default: 0]")
        ->check(CLI::Range(0, 1024))
        ->option_text("N");
}

void add_film_options(CLI::App& command, RenderSettings& settings) {
    add_parsed(command, "--resolution", settings.resolution_px, parse_resolution,
               "Size of the full frame in pixels [default: the scene's]", "WxH");
    add_parsed(command, "--crop", settings.crop, parse_crop,
               "Only these pixels of the frame, X1 and Y1 not among them [default: the scene's crop, or all]",
               "X0,Y0,X1,Y1");
    add_named_option(command, "--filter", "filter", settings.filter, "Reconstruction filter", "the scene's");
    command.add_flag_callback(
        "--splat", [&settings] { settings.filter_use = FilterUse::splatted; },
        "Spread each sample over the pixels that the filter reaches [default: draw its place by the filter]");
    add_named_option(command, "--firefly", "firefly control", settings.firefly_control,
                     "What is done against fireflies; its bias stands in the EXR's header");
    command
        .add_option_function<std::string>(
            "--observer",
            [&settings](const std::string& name) {
                check_option("--observer", SensorOptions{.observer = name});
                settings.observer = name;
            },
            fmt::format("Whose X Y Z the film holds [default: {}]; one of\n  {}", SensorOptions{}.observer,
                        fmt::join(observer_names(), ", ")))
        ->option_text("NAME");
    command
        .add_option("--sensor", settings.sensor,
                    "See as a camera does: its measured curves, columns wavelength (nm), r, g, b [default: as the "
                    "observer does]")
        ->option_text("CAMERA.csv");
}

void add_layer_options(CLI::App& command, RenderSettings& settings) {
    add_parsed(command, "--variance", settings.variance, parse_variance,
               "Layers of the variance and the standard error of luminance, or of xyz [default: none]", "NAME");
    add_parsed(command, "--aov", settings.aux, parse_aux,
               "Layers of what is seen first: albedo, normal, depth, separated by commas [default: none]", "NAMES");
    add_parsed(command, "--spectrum", settings.spectrum, parse_spectrum,
               fmt::format("Radiance in N buckets of wavelengths [default: none; range {:g}-{:g} nm]",
                           SpectralBuckets{}.min_nm, SpectralBuckets{}.max_nm),
               "N[:MIN-MAX]");
}

/// Empty if the text is a time, else what is wrong with it.
std::string is_seconds(const std::string& text) {
    double seconds = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    if (whole && std::isfinite(seconds) && seconds > 0.0) return {};
    return "found \"" + text + "\", expected a number of seconds above 0";
}

void add_state_options(CLI::App& command, RenderSettings& settings) {
    command
        .add_option("--checkpoint", settings.checkpoint_s,
                    "Every so many seconds, and at the end, write a film state: NAME.film.exr beside NAME.exr "
                    "[default: none]")
        ->check(is_seconds)
        ->option_text("SECONDS");
    command.add_flag("--resume", settings.resume,
                     "Go on from that state, if it is there [default: start anew and replace it]");
    add_parsed(command, "--shard", settings.shard, parse_shard,
               "Only share I of N of the samples; the output must be a .film.exr [default: all]", "I/N");
}

void check_together(const RenderSettings& settings) {
    require_distinct({{"SCENE", settings.scene}, {"--output", settings.output}, {"--png", settings.png}});
    if (settings.shard && !is_state_name(settings.output)) {
        throw CLI::ValidationError("--shard", "found the output \"" + settings.output.string() +
                                                  "\", expected --output NAME.film.exr: shares are merged as states");
    }
}

}  // namespace

SampleRange samples_of(const Shard& shard, int samples_per_pixel) noexcept {
    const auto samples = static_cast<std::uint64_t>(samples_per_pixel), count = static_cast<std::uint64_t>(shard.count);
    const auto number = static_cast<std::uint64_t>(shard.number);
    return {samples * (number - 1) / count, samples * number / count};
}

void add_render_options(CLI::App& command, RenderSettings& settings) {
    add_file_options(command, settings);
    add_sample_options(command, settings);
    add_film_options(command, settings);
    add_layer_options(command, settings);
    add_state_options(command, settings);
    add_exr_options(command, settings.exr);
    command.add_flag("--quiet", settings.quiet, "No progress and no summary; warnings and errors only [default: both]");
    add_pipeline_options(command, settings.pipeline);
    command.final_callback([&settings] { check_together(settings); });
}

void apply(const RenderSettings& settings, Scene& scene) {
    if (settings.resolution_px) std::tie(scene.film.width_px, scene.film.height_px) = *settings.resolution_px;
    if (settings.crop) {
        scene.film.crop_window.reset();
        scene.film.pixel_bounds = settings.crop;
    }
    if (settings.filter) scene.filter = *settings.filter;
    if (settings.observer) scene.film.sensor.observer = *settings.observer;
    if (settings.sensor) scene.film.sensor.camera = CameraSensor{read_camera_response(*settings.sensor)};
}

FilmOptions film_options(const RenderSettings& settings, const Scene& scene) {
    FilmOptions options = emulsion::film_options(scene);
    options.filter_use = settings.filter_use;
    options.variance = settings.variance;
    options.spectrum = settings.spectrum;
    options.aux = settings.aux;
    options.firefly_control = settings.firefly_control;
    return options;
}

RenderOptions render_options(const RenderSettings& settings, const Scene& scene) {
    RenderOptions options;
    options.samples_per_pixel = settings.samples_per_pixel.value_or(samples_per_pixel(scene.sampler));
    options.seed = settings.seed.value_or(static_cast<std::uint64_t>(scene.sampler_seed));
    options.wavelengths = settings.wavelengths;
    options.threads = settings.threads;
    if (!settings.shard) return options;
    options.samples = samples_of(*settings.shard, options.samples_per_pixel);
    if (options.samples->size() > 0) return options;
    throw std::runtime_error(
        fmt::format("--shard {}/{}: this share of {} samples per pixel is empty, expected at most "
                    "as many shares as samples",
                    settings.shard->number, settings.shard->count, options.samples_per_pixel));
}

ExrOptions exr_options(const RenderSettings& settings, const Scene& scene) {
    ExrOptions options = exr_options(settings.exr, scene.film.pixel_type, settings.threads);
    options.white_luminance_cdm2 = white_luminance_cdm2(scene.film.sensor);
    return options;
}

}  // namespace emulsion::cli
