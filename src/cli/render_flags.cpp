#include <cstdint>
#include <limits>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/distinct_files.h"
#include "cli/file_names.h"
#include "cli/named_option.h"
#include "cli/option_checks.h"
#include "cli/pipeline_options.h"
#include "cli/render_settings.h"
#include "cli/render_values.h"
#include "film/sensor_options.h"
#include "spectrum/observer.h"

// The flags of `emulsion render`, by what they are about.

namespace emulsion::cli {

namespace {

/// A flag whose text `parse` turns into `target`.
template <class Target, class Parse>
CLI::Option* add_parsed(CLI::App& command, const char* flag, Target& target, Parse parse, const std::string& help,
                        const char* value_name) {
    return command
        .add_option_function<std::string>(
            flag, [&target, parse](const std::string& text) { target = parse(text); }, help)
        ->option_text(value_name);
}

std::string model_help() {
    std::string help = fmt::format("How light is carried [default: {}]; one of", to_text(TransportModel{}));
    for (const auto& [form, text] : describe_transport_models()) help += fmt::format("\n  {}: {}", form, text);
    return help + fmt::format(
                      "\n  auto[:MEAN[,P99]]: the cheapest of them whose colour error is predicted within a mean and a "
                      "99th percentile of CIEDE2000 [{:g},{:g}]",
                      ErrorBudget{}.mean, ErrorBudget{}.p99);
}

void add_file_options(CLI::App& command, RenderSettings& settings) {
    command.add_option("SCENE", settings.scene, "Scene file in pbrt-v4 syntax")->required()->option_text(" ");
    command
        .add_option("-o,--output", settings.output,
                    "Scene-referred EXR: X Y Z, Y in cd/m^2, and the layers asked for; a name ending in .film.exr "
                    "makes it a film state, which also holds all that is needed to go on [default: the scene's film "
                    "name, ending in .exr]")
        ->check(ends_in_exr)
        ->option_text("FILE");
    command
        .add_option("--png", settings.png,
                    "Also develop the picture to this PNG, 8-bit sRGB but for what --pipeline says [default: none]")
        ->check(ends_in_png)
        ->option_text("FILE");
}

void add_sample_options(CLI::App& command, RenderSettings& settings) {
    command.add_option("--spp", settings.samples_per_pixel, "Samples per pixel, 1 to 16777216 [default: the scene's]")
        ->check(whole_number_check(1, kMostSamplesPerPixel))
        ->option_text("N");
    command.add_option("--seed", settings.seed, "Seed of the random numbers, >= 0 [default: the scene's, or 0]")
        ->check(whole_number_check(0, std::numeric_limits<std::uint64_t>::max()))
        ->option_text("N");
    command
        .add_option("--until", settings.until,
                    "Stop each tile of 16x16 pixels when the standard error of its colour is at most DE, CIEDE2000, "
                    "and give none more than --spp [default: all samples everywhere]; unbiased: what decides is an "
                    "eighth more paths, a quarter at first, which are not in the picture")
        ->check(is_color_difference)
        ->option_text("DE");
    add_parsed(
        command, "--model", settings.model,
        [](const std::string& text) { return parse_named_option("--model", [&] { return parse_model_choice(text); }); },
        model_help(), "MODEL");
    add_threads_option(command, settings.threads);
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
        ->option_text("FILE.csv");
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

void check_settings(const RenderSettings& settings) {
    require_distinct({{"SCENE", settings.scene}, {"--output", settings.output}, {"--png", settings.png}});
    if (!settings.png.empty()) check_for_png(settings.pipeline);
    if (settings.until && settings.shard) {
        throw CLI::ValidationError("--until",
                                   "found --shard as well, expected one of the two: tiles that stop on their "
                                   "own have no samples to share out");
    }
    if (settings.until && settings.filter_use == FilterUse::splatted) {
        throw CLI::ValidationError("--until",
                                   "found --splat as well, expected one of the two: where samples are "
                                   "spread, those of the tile that has more outweigh its neighbour's");
    }
    if (settings.shard && !is_state_name(settings.output)) {
        throw CLI::ValidationError("--shard", "found the output \"" + settings.output.string() +
                                                  "\", expected --output NAME.film.exr: shares are merged as states");
    }
}

}  // namespace

void add_render_options(CLI::App& command, RenderSettings& settings) {
    add_file_options(command, settings);
    add_sample_options(command, settings);
    add_film_options(command, settings);
    add_layer_options(command, settings);
    add_state_options(command, settings);
    add_exr_options(command, settings.exr);
    command.add_flag("--quiet", settings.quiet, "No progress and no summary; warnings and errors only [default: both]");
    add_pipeline_options(command, settings.pipeline);
    command.final_callback([&settings] { check_settings(settings); });
}

}  // namespace emulsion::cli
