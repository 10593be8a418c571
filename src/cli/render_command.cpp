#include "cli/render_command.h"

#include <charconv>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/distinct_files.h"
#include "cli/loss_warnings.h"
#include "cli/messages.h"
#include "cli/named_option.h"
#include "cli/pipeline_options.h"
#include "cli/progress_display.h"
#include "cli/stop_signals.h"
#include "core/atomic_file.h"
#include "core/named_value.h"
#include "film/exr_file.h"
#include "film/film.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/render.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/scene_parser.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion::cli {

struct RenderCommand::Options {
    std::filesystem::path scene, exr, png;
    std::optional<int> samples_per_pixel;
    std::optional<std::pair<int, int>> resolution_px;
    std::optional<std::uint64_t> seed;
    int wavelengths = RenderOptions{}.wavelengths;
    int threads = 0;
    ExrOptions exr_options;
    bool rgb = false, half = false, quiet = false;
    Pipeline pipeline;
};

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

/// "640x480".
std::pair<int, int> parse_resolution(const std::string& text) {
    std::pair<int, int> size{0, 0};
    const std::size_t cross = text.find('x');
    const auto refuse = [&text] {
        throw CLI::ValidationError("--resolution", "found \"" + text + "\", expected WIDTHxHEIGHT in pixels");
    };
    if (cross == std::string::npos) refuse();
    const auto read = [&](std::string_view digits, int& value) {
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool whole = error == std::errc{} && end == digits.data() + digits.size();
        if (!whole) refuse();
    };
    read(std::string_view(text).substr(0, cross), size.first);
    read(std::string_view(text).substr(cross + 1), size.second);
    check_option("--resolution", FilmOptions{.width_px = size.first, .height_px = size.second});
    return size;
}

/// Empty if the text is one of 0, 1, ..., 2^64 - 1, else what is wrong with it.
std::string is_whole_number(const std::string& text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size()) return {};
    return "found \"" + text + "\", expected a whole number from 0 to 18446744073709551615";
}

/// Empty if the name is right, else what is wrong with it.
std::string ends_in_exr(const std::string& name) {
    const std::string extension = std::filesystem::path(name).extension();
    if (extension == ".exr" || extension == ".EXR") return {};
    return "found \"" + name + "\", expected a name ending in .exr (--png writes a PNG)";
}

double elapsed_s(std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

FilmMetadata metadata_of(const Film& film, const std::string& filter, const RenderOptions& options,
                         const std::string& command_line) {
    FilmMetadata metadata;
    metadata.samples_per_pixel = static_cast<std::int64_t>(film.min_samples_per_pixel());
    metadata.sample_count = film.sample_count();
    const DroppedSamples dropped = film.dropped();
    metadata.dropped_nan_count = dropped.count(DroppedKind::nan);
    metadata.dropped_infinite_count = dropped.count(DroppedKind::infinite);
    metadata.dropped_negative_luminance_count = dropped.count(DroppedKind::negative_luminance);
    metadata.seed = options.seed;
    metadata.renderer_version = "emulsion " EMULSION_VERSION;
    metadata.command_line = command_line;
    metadata.filter = filter;
    return metadata;
}

/// The picture as the EXR just written holds it.
Image<XYZ> read_back(const Image<XYZ>& picture, const std::filesystem::path& exr, const ExrOptions& options) {
    if (!is_lossy(options.compression)) return as_stored(picture, options);
    return read_exr(exr, {.layers = ExrLayers::skip, .threads = options.threads}).xyz;
}

/// The EXR's name where the command line gives none: the scene's, in the current folder.
std::filesystem::path default_exr(const std::filesystem::path& scene_file, const Scene& scene) {
    std::filesystem::path exr =
        scene.film.filename.empty() ? scene_file.filename() : std::filesystem::path(scene.film.filename);
    exr.replace_extension(".exr");
    return exr;
}

/// render(), shown as it goes; warns if it was stopped early.
/// \throws std::runtime_error if it was stopped before there was anything to write.
void render_with_progress(const PreparedScene& scene, const RenderOptions& options, Film& film,
                          RenderProgress& progress, ProgressStyle style) {
    const PixelBounds bounds = film.bounds();
    const std::int64_t total = static_cast<std::int64_t>(bounds.width()) * bounds.height() * options.samples_per_pixel;
    {
        const ProgressDisplay display(style, progress, total);
        render(scene, options, film, progress);
    }
    if (progress.samples_done == 0) throw std::runtime_error("stopped before the first samples; nothing was written");
    if (progress.samples_done < total) {
        print_warning(fmt::format("stopped early, at {} to {} of {} samples per pixel; writing what there is",
                                  film.min_samples_per_pixel(), film.max_samples_per_pixel(),
                                  options.samples_per_pixel));
    }
}

}  // namespace

RenderCommand::RenderCommand(CLI::App& program)
    : command_(program.add_subcommand("render", "Render a pbrt-v4 scene to an EXR, and to a PNG")),
      options_(std::make_unique<Options>()) {
    Options& options = *options_;
    command_->add_option("SCENE", options.scene, "Scene file in pbrt-v4 syntax")->required()->option_text(" ");
    CLI::Option* exr_option =
        command_
            ->add_option("-o,--output", options.exr,
                         "Scene-referred EXR, Y in cd/m^2 [default: the scene's film name, ending in .exr]")
            ->option_text("FILE");
    exr_option->check(ends_in_exr);
    command_->add_option("--png", options.png, "Also develop the picture to this 8-bit sRGB PNG [default: none]")
        ->option_text("FILE");
    command_
        ->add_option_function<int>(
            "--spp",
            [&options](int samples) {
                check_option("--spp", RenderOptions{.samples_per_pixel = samples});
                options.samples_per_pixel = samples;
            },
            "Samples per pixel, >= 1 [default: the scene's]")
        ->option_text("N");
    command_
        ->add_option_function<std::string>(
            "--resolution", [&options](const std::string& text) { options.resolution_px = parse_resolution(text); },
            "Size of the picture in pixels [default: the scene's]")
        ->option_text("WxH");
    command_->add_option("--seed", options.seed, "Seed of the random numbers, >= 0 [default: the scene's, or 0]")
        ->check(is_whole_number)
        ->option_text("N");
    command_
        ->add_option("--wavelengths", options.wavelengths,
                     fmt::format("Wavelengths per path, one of {} [default: {}]", fmt::join(kWavelengthCounts, ", "),
                                 options.wavelengths))
        ->check(CLI::IsMember(std::vector<int>(kWavelengthCounts.begin(), kWavelengthCounts.end())))
        ->option_text("N");
    command_->add_option("--threads", options.threads, "Threads, 0 to 1024; 0: one per processor [default: 0]")
        ->check(CLI::Range(0, 1024))
        ->option_text("N");
    CLI::Option* space =
        command_
            ->add_option_function<std::string>(
                "--space",
                [&options](const std::string& name) {
                    options.exr_options.space = name;
                    check_option("--space", options.exr_options);
                },
                fmt::format("Channels of the EXR: XYZ, or linear R G B of a space [default: {}]; one of\n  {}",
                            options.exr_options.space, fmt::join(exr_space_names(), ", ")))
            ->option_text("NAME");
    command_->add_flag("--rgb", options.rgb, "Short for --space sRGB: linear, with the primaries of Rec. 709")
        ->excludes(space);
    add_named_option(*command_, "--compression", "compression", options.exr_options.compression,
                     "Compression of the EXR");
    command_->add_flag("--half", options.half, "Write 16-bit floats into the EXR [default: 32-bit ones]");
    command_->add_flag("--quiet", options.quiet,
                       "No progress and no summary; warnings and errors only [default: both]");
    add_pipeline_options(*command_, options.pipeline);
    command_->final_callback([&options] {
        require_distinct({{"SCENE", options.scene}, {"--output", options.exr}, {"--png", options.png}});
    });
}

RenderCommand::~RenderCommand() = default;

bool RenderCommand::chosen() const { return command_->parsed(); }

int RenderCommand::run(const std::string& command_line) const {
    const auto start = std::chrono::steady_clock::now();
    const Options& options = *options_;

    // The scene's settings, and the command line's over them.
    Scene scene = read_scene(options.scene);
    for (const std::string& warning : scene.warnings) print_warning(warning);
    if (options.resolution_px) std::tie(scene.film.width_px, scene.film.height_px) = *options.resolution_px;
    RenderOptions render_options;
    render_options.samples_per_pixel = options.samples_per_pixel.value_or(samples_per_pixel(scene.sampler));
    render_options.seed = options.seed.value_or(static_cast<std::uint64_t>(scene.sampler_seed));
    render_options.wavelengths = options.wavelengths;
    render_options.threads = options.threads;
    ExrOptions exr_options = options.exr_options;
    if (options.rgb) exr_options.space = "sRGB";
    exr_options.pixel_type = options.half ? PixelType::half : scene.film.pixel_type;
    exr_options.threads = options.threads;
    const std::filesystem::path exr = options.exr.empty() ? default_exr(options.scene, scene) : options.exr;

    // What can't be written is found out before the work, not after.
    require_distinct({{"SCENE", options.scene}, {"the scene's film name", exr}, {"--png", options.png}});
    check_writable(exr);
    if (!options.png.empty()) check_writable(options.png);

    // Until the last file is written, Ctrl-C leaves no half of it behind.
    Film film(film_options(scene));
    exr_options.white_luminance_cdm2 = white_luminance_cdm2(film.options().sensor);
    const std::string filter = to_text(scene.filter);
    const PreparedScene prepared(std::move(scene), options.threads);
    RenderProgress progress;
    const StopSignals stop_signals(progress.stop);
    render_with_progress(prepared, render_options, film, progress,
                         options.quiet ? ProgressStyle::none : progress_style_for_stderr());
    const double render_s = elapsed_s(start);
    warn_of_losses(film);

    // The PNG is made from what the EXR holds, so that `develop` makes the same one.
    const Image<XYZ> picture = film.xyz_image();
    const ExrWriteResult written =
        write_exr(exr, picture, metadata_of(film, filter, render_options, command_line), exr_options);
    for (const std::string& loss : exr_losses(written, exr_options.pixel_type)) {
        print_warning(exr.string() + ": " + loss);
    }
    if (!options.png.empty()) {
        develop_to_png(read_back(picture, exr, exr_options), options.pipeline, options.threads, options.png);
    }
    if (!options.quiet) {
        print_output(fmt::format("{}x{} pixels, {} samples each, in {:.2f} s\nwrote {}\n", picture.width(),
                                 picture.height(), film.min_samples_per_pixel(), render_s, exr.string()));
        if (!options.png.empty()) print_output(fmt::format("wrote {}\n", options.png.string()));
    }
    return kDone;
}

}  // namespace emulsion::cli
