#include "cli/render_command.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/model_analysis.h"
#include "cli/checkpoints.h"
#include "cli/distinct_files.h"
#include "cli/file_names.h"
#include "cli/film_files.h"
#include "cli/loss_warnings.h"
#include "cli/messages.h"
#include "cli/pipeline_options.h"
#include "cli/progress_display.h"
#include "cli/render_resume.h"
#include "cli/render_settings.h"
#include "cli/samples_text.h"
#include "cli/stop_signals.h"
#include "core/atomic_file.h"
#include "film/film.h"
#include "pathtracer/film_in_progress.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"
#include "pathtracer/stopping_rule.h"

namespace emulsion::cli {

struct RenderCommand::Options : RenderSettings {};

namespace {

double elapsed_s(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

/// The EXR's name where the command line gives none: the scene's, in the current folder.
std::filesystem::path default_exr(const std::filesystem::path& scene_file, const Scene& scene) {
    std::filesystem::path exr =
        scene.film.filename.empty() ? scene_file.filename() : std::filesystem::path(scene.film.filename);
    exr.replace_extension(".exr");
    return exr;
}

/// What is written, and where; `state` is empty if there is none beside the output.
struct OutputFiles {
    std::filesystem::path output, png, state;
};

OutputFiles output_files(const RenderSettings& settings, const Scene& scene) {
    OutputFiles files{settings.output.empty() ? default_exr(settings.scene, scene) : settings.output, settings.png, {}};
    const std::filesystem::path state = state_name(files.output);
    if (settings.checkpoint_s && state != files.output) files.state = state;
    std::vector<NamedFile> inputs = {{"SCENE", settings.scene}, {"--sensor", settings.sensor.value_or("")}};
    for (const std::filesystem::path& file : scene.files) inputs.push_back({"a file that the scene reads", file});
    // A state that is gone on from may be written over by its successor only.
    if (settings.resume && files.state.empty() && state != files.output) inputs.push_back({"--resume", state});
    for (const NamedFile& input : inputs) {
        require_distinct(
            {input, {"the scene's film name", files.output}, {"--png", files.png}, {"--checkpoint", files.state}});
    }
    // What can't be written is found out before the work, not after.
    check_writable(files.output);
    if (!files.png.empty()) check_writable(files.png);
    if (!files.state.empty()) check_writable(files.state);
    return files;
}

/// The state that the render is to go on from: none if nobody asked for it, or if it isn't there.
std::optional<FilmState> resumed_state(const RenderSettings& settings, const RenderStart& start,
                                       const std::filesystem::path& output) {
    if (!settings.resume) return std::nullopt;
    const std::filesystem::path path = state_name(output);
    const auto say = [&](const std::string& text) {
        if (!settings.quiet) print_output(text);
    };
    if (!std::filesystem::exists(path)) {
        say(fmt::format("nothing to resume: there is no {}\n", path.string()));
        return std::nullopt;
    }
    FilmState state = read_state_for(start, path);
    say(fmt::format("resuming from {}, which has {} of each pixel\n", path.string(), samples_text(state.provenance)));
    return state;
}

/// How many samples of each pixel the film has.
std::string taken_text(const FilmInProgress& film) {
    const FilmProvenance provenance = film.provenance();
    return film.film().with_contents([&](const auto& contents) { return count_text(provenance, contents); });
}

/// render(), shown as it goes, and kept in a state file from time to time; warns if it was stopped early.
/// \throws std::runtime_error if it was stopped before there was anything to write.
void render_with_progress(const PreparedScene& scene, const RenderOptions& options, FilmInProgress& film,
                          RenderProgress& progress, const RenderSettings& settings,
                          const std::function<void()>& write_state) {
    {
        const Checkpoints checkpoints(settings.checkpoint_s, write_state);
        const ProgressDisplay display(settings.quiet ? ProgressStyle::none : progress_style_for_stderr(), progress,
                                      film.missing_paths(samples_of(options)));
        render(scene, options, film, progress);
    }
    if (film.missing_paths(samples_of(options)) == 0) return;
    if (film.film().max_samples_per_pixel() == 0 && film.film().dropped().count() == 0) {
        throw std::runtime_error("stopped before the first samples; nothing was written");
    }
    print_warning(fmt::format("stopped early, at {} of {} samples per pixel; writing what there is", taken_text(film),
                              samples_of(options).size()));
}

/// What --until has come to.
std::string until_text(const FilmInProgress& film, const RenderOptions& options) {
    const std::size_t tiles = tile_count(film.film().sample_bounds(), kTileSize_px), stopped = film.tiles_left_out();
    if (film.provenance().samples.count() < StoppingRule::kFirstLook) {
        return fmt::format("standard error of colour not looked at: that is first done after {} samples\n",
                           StoppingRule::kFirstLook);
    }
    std::string text = fmt::format("standard error of colour at most {:g}, estimated, in {} of {} tiles",
                                   *options.until, stopped, tiles);
    if (stopped < tiles && film.missing_paths(samples_of(options)) == 0) text += "; the others have all samples";
    return text + "\n";
}

/// What was rendered, and what was written.
void print_summary(const FilmInProgress& film, const RenderOptions& options, const OutputFiles& files,
                   double render_s) {
    const PixelBounds& bounds = film.film().bounds();
    print_output(fmt::format("{}x{} pixels, {} samples each, in {:.2f} s\n", bounds.width(), bounds.height(),
                             taken_text(film), render_s));
    if (options.until) print_output(until_text(film, options));
    for (const auto& file : {files.output, files.png, files.state}) {
        if (!file.empty()) print_output(fmt::format("wrote {}\n", file.string()));
    }
}

}  // namespace

RenderCommand::RenderCommand(CLI::App& program)
    : command_(program.add_subcommand("render", "Render a pbrt-v4 scene to an EXR, and to a PNG")),
      options_(std::make_unique<Options>()) {
    add_render_options(*command_, *options_);
}

RenderCommand::~RenderCommand() = default;

bool RenderCommand::chosen() const { return command_->parsed(); }

int RenderCommand::run(const std::string& command_line) const {
    const auto begun = std::chrono::steady_clock::now();
    const RenderSettings& settings = *options_;

    // The scene's settings, and the command line's over them.
    Scene scene = read_scene(settings.scene);
    for (const std::string& warning : scene.warnings) print_warning(warning);
    apply(settings, scene);
    RenderOptions options = render_options(settings, scene);
    const ExrOptions exr = exr_options(settings, scene);
    const FilmOptions film_is = film_options(settings, scene);
    const OutputFiles files = output_files(settings, scene);

    // What carries the light.
    PreparedScene prepared(std::move(scene), options.threads, options.model);
    std::string model = to_text(options.model);
    if (const auto* wish = std::get_if<AutoModel>(&settings.model)) {
        const ModelAnalysis analysis = analyse_models(prepared, wish->budget, {.threads = options.threads});
        options.model = analysis.models[analysis.chosen].model;
        model = reasons(analysis, "; ");
        if (!settings.quiet) print_output(reasons(analysis) + "\n");
    }
    const FilmMetadata run{.seed = options.seed,
                           .renderer_version = "emulsion " EMULSION_VERSION,
                           .command_line = command_line,
                           .model = model};

    // The film, new or as it was left.
    const RenderStart start{film_is, provenance_of(prepared.scene(), options), samples_of(options)};
    std::optional<FilmState> state = resumed_state(settings, start, files.output);
    Film film = state ? Film(start.film, std::move(state->contents)) : Film(start.film);
    FilmInProgress in_progress(film, state ? state->provenance : start.provenance);
    state.reset();

    const std::filesystem::path& state_file = files.state.empty() ? files.output : files.state;
    const auto write_state = [&] { write_film_state(state_file, state_of(in_progress, run), exr); };
    // Until the last file is written, Ctrl-C leaves no half of it behind.
    RenderProgress progress;
    const StopSignals stop_signals(progress.stop);
    render_with_progress(prepared, options, in_progress, progress, settings, write_state);
    const double render_s = elapsed_s(begun);
    warn_of_losses(film);

    // The state first: from then on the pictures can be had again. The PNG is made from what the EXR holds, so that
    // `develop` makes the same one.
    if (!files.state.empty()) write_state();
    const Image<XYZ> picture =
        write_film(files.output, in_progress, run, exr, auto_pixels(settings.exr, settings.quiet));
    if (!files.png.empty()) {
        const DevelopResult developed = develop_to_png(picture, settings.pipeline, options.threads, files.png);
        if (!settings.quiet) report_gamut(developed, settings.pipeline);
    }
    if (!settings.quiet) print_summary(in_progress, options, files, render_s);
    return kDone;
}

}  // namespace emulsion::cli
