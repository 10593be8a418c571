#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/color_arguments.h"
#include "cli/compare_settings.h"
#include "cli/distinct_files.h"
#include "cli/number_list.h"
#include "cli/option_checks.h"
#include "cli/pipeline_options.h"
#include "cli/render_values.h"
#include "pathtracer/render.h"

// The flags of `emulsion compare`, by what they are about.

namespace emulsion::cli {

namespace {

/// A finite number above 0, no more than `most`.
OptionCheck positive_number_check(double most) {
    return [most](const std::string& text) -> std::string {
        const auto value = number_of<double>(text);
        if (value && *value > 0.0 && *value <= most) return {};
        return found_expected(text, "a number above 0");
    };
}

DifferenceLimits parse_limits(const std::string& text) {
    const std::size_t comma = text.find(',');
    const auto limit = [&](const std::string& word) {
        const auto value = number_of<double>(word);
        if (value && std::isfinite(*value) && *value >= 0.0) return *value;
        throw CLI::ValidationError("--fail-above", found_expected(text, "MEAN or MEAN,P99, each >= 0"));
    };
    DifferenceLimits limits{.mean = limit(text.substr(0, comma))};
    if (comma != std::string::npos) limits.p99 = limit(text.substr(comma + 1));
    return limits;
}

void add_again_option(CLI::App& command, const std::string& flag, CompareInput& input, const std::string& name) {
    command
        .add_option(flag, input.again,
                    "The picture of " + name + " once more, rendered with another seed: the mean of both is " + name +
                        ", and how far they are apart tells its noise, whatever the sampler [default: what "
                        "the film's layers say]")
        ->option_text("FILE");
}

void add_white_options(CLI::App& command, CompareSettings& settings) {
    command
        .add_option_function<std::string>(
            "--white",
            [&settings](const std::string& text) {
                // Only the pictures tell their observer: this is to find bad usage at once.
                parse_for("--white", [&] { return parse_white(text); });
                settings.white = text;
            },
            "White of CIELAB: an illuminant, or its chromaticity [default: D65 of the pictures' observer]")
        ->option_text("NAME|x,y");
    command
        .add_option("--white-luminance", settings.white_luminance_cdm2,
                    "Luminance that is shown as white, cd/m^2 [default: that of which the log-average of A's luminance "
                    "is 18 %]")
        ->check(positive_number_check(1e30))
        ->option_text("CDM2");
    add_pipeline_text_option(command, settings.pipeline, "The stages of which the PSNR is");
}

void add_result_options(CLI::App& command, CompareSettings& settings) {
    command
        .add_option("--map", settings.map, "Draw CIEDE2000 of each pixel in false colour, with a scale [default: none]")
        ->check(ends_in_png)
        ->option_text("FILE.png");
    command
        .add_option(
            "--map-end", settings.map_end,
            "CIEDE2000 at the end of its scale [default: 1, 2, 3, 5, 10, ..., the first that 99 % of the pixels "
            "do not exceed]")
        ->check(positive_number_check(1e6))
        ->option_text("NUMBER");
    command
        .add_option_function<std::string>(
            "--fail-above", [&settings](const std::string& text) { settings.limits = parse_limits(text); },
            "Exit with 1 if CIEDE2000 is above these, or a pixel finite in A is not in B [default: none]")
        ->option_text("MEAN[,P99]");
    command.add_flag("--json", settings.json, "One JSON object [default: lines for people]");
}

void add_scene_options(CLI::App& command, SceneRenderSettings& settings) {
    command
        .add_option("--spp", settings.samples_per_pixel,
                    "Of scenes: samples per pixel, 2 to 16777216 [default: the scene's]")
        ->check(whole_number_check(2, kMostSamplesPerPixel))
        ->option_text("N");
    command.add_option("--seed", settings.seed, "Of scenes: which random numbers, 0 to 1000000000 [default: 0]")
        ->check(whole_number_check(0, 1000000000))
        ->option_text("N");
    command
        .add_option_function<std::string>(
            "--resolution", [&settings](const std::string& text) { settings.resolution_px = parse_resolution(text); },
            "Of scenes: size of the full frame in pixels [default: the scene's]")
        ->option_text("WxH");
    add_threads_option(command, settings.threads);
}

void check_input(const std::string& name, const std::string& again_flag, const CompareInput& input,
                 const CompareSettings& settings) {
    const std::filesystem::path file = parse_for(name, [&] { return file_of(input.text); });
    require_distinct({{name, file}, {again_flag, input.again}, {"--map", settings.map}});
    if (!input.again.empty() && parse_scene_with_model(input.text)) {
        throw CLI::ValidationError(again_flag, "is for pictures in files: scenes are rendered twice anyway");
    }
}

void check_settings(const CompareSettings& settings) {
    check_input("A", "--a-again", settings.a, settings);
    check_input("B", "--b-again", settings.b, settings);
    check_together(settings.pipeline);
    if (settings.map_end && settings.map.empty()) {
        throw CLI::ValidationError("--map-end", "needs --map, whose scale it is for");
    }
}

}  // namespace

void add_compare_options(CLI::App& command, CompareSettings& settings) {
    command
        .add_option(
            "A", settings.a.text,
            "The reference, which says what white is: an EXR with X Y Z or R G B (film state, film picture or "
            "any other), PNG, PFM or Radiance picture; or SCENE.pbrt@MODEL, to be rendered by a model of transport, "
            "as of `render --model`")
        ->required()
        ->option_text(" ");
    command.add_option("B", settings.b.text, "What is compared with it, likewise")->required()->option_text(" ");
    add_again_option(command, "--a-again", settings.a, "A");
    add_again_option(command, "--b-again", settings.b, "B");
    add_white_options(command, settings);
    add_result_options(command, settings);
    add_scene_options(command, settings.scenes);
    command.final_callback([&settings] { check_settings(settings); });
}

}  // namespace emulsion::cli
