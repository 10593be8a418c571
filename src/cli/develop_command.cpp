#include "cli/develop_command.h"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/distinct_files.h"
#include "cli/messages.h"
#include "cli/option_checks.h"
#include "cli/picture_output.h"
#include "cli/pipeline_options.h"
#include "cli/tone_reports.h"
#include "core/atomic_file.h"
#include "develop/develop.h"
#include "develop/picture_file.h"

namespace emulsion::cli {

namespace {

/// What the flags said.
struct DevelopSettings {
    std::filesystem::path picture, output, contact_sheet, exposures, curve;
    int threads = 0, png_level = kDefaultPngLevel;
    bool quiet = false, list_tonemaps = false, list_adaptations = false, show_pipeline = false;
    Pipeline pipeline;
};

/// That its stages go together, and that a PNG can say what its code values mean.
void check_pipeline(const DevelopSettings& options) {
    const bool png_output = !options.output.empty() && picture_format(options.output) == PictureFormat::png;
    const bool writes_png = png_output || !options.contact_sheet.empty() || !options.exposures.empty();
    try {
        validate(options.pipeline);
        if (writes_png) validate(png_options(options.pipeline));
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("pipeline", error.what());
    }
}

/// What only all flags together can tell.
void check_settings(const DevelopSettings& options) {
    if (options.list_tonemaps || options.list_adaptations) return;
    check_pipeline(options);
    if (options.show_pipeline) return;
    if (options.picture.empty()) throw CLI::ValidationError("PICTURE", "found none, expected a file");
    if (options.output.empty() && options.contact_sheet.empty() && options.exposures.empty() && options.curve.empty()) {
        throw CLI::ValidationError("--output", "found none, expected it, --contact-sheet, --exposures or --curve");
    }
    require_distinct({{"PICTURE", options.picture},
                      {"--output", options.output},
                      {"--contact-sheet", options.contact_sheet},
                      {"--exposures", options.exposures},
                      {"--curve", options.curve}});
}

void add_file_options(CLI::App& command, DevelopSettings& options) {
    command
        .add_option(
            "PICTURE", options.picture,
            "EXR with channels X Y Z or R G B, as `emulsion render` writes it; or a Radiance picture, a PFM, or "
            "a PNG whose white is 1 cd/m^2: by its contents, not by its name")
        ->option_text(" ");
    command
        .add_option("-o,--output", options.output,
                    "PNG; or a name ending in .pfm or .hdr for the picture as tone mapping would get it, after --bloom "
                    "and --vision: linear Rec. 709, (1, 1, 1) for a white of 1 cd/m^2")
        ->check(ends_in_picture)
        ->option_text("FILE");
    command.add_option("--contact-sheet", options.contact_sheet, "PNG with a labelled tile for each operator")
        ->check(ends_in_png)
        ->option_text("FILE");
    command
        .add_option("--png-level", options.png_level,
                    fmt::format("Compression of the PNG, 0 (none) to 9 (smallest) [default: {}]; 6 is as libpng does "
                                "it, the default as small on pictures and several times as fast",
                                kDefaultPngLevel))
        ->check(whole_number_check(0, 9))
        ->option_text("N");
    command
        .add_option("--exposures", options.exposures,
                    "PNG strip of three exposures, with ten times the white of --tonemap fixed, with it, and with a "
                    "tenth of it; under another operator, around a tenth of the picture's bright end")
        ->check(ends_in_png)
        ->option_text("FILE");
    command
        .add_option("--curve", options.curve,
                    "CSV of the operator's luminance curve for this picture: cd/m^2, display luminance")
        ->option_text("FILE");
    command.add_flag("--list-tonemaps", options.list_tonemaps, "Print every operator, and end");
    command.add_flag("--list-adaptations", options.list_adaptations,
                     "Print every adaptation luminance that an operator may be given, and end");
}

/// The stages before tone mapping are gone through once, for all outputs.
void write_outputs(const DevelopSettings& options, Image<XYZ> picture) {
    const int threads = options.threads;
    Pipeline rest = options.pipeline;
    if (std::optional<Image<XYZ>> before = before_tone_mapping(picture, rest, threads)) picture = std::move(*before);
    rest.bloom = NoBloom{};
    rest.vision = NoVision{};
    const SceneLuminance luminance(picture.view(), threads);
    warn_of_bad_pixels(luminance.statistics());

    if (!options.curve.empty()) write_curve(options.curve, picture, {rest.tone_mapper, rest.adaptation}, threads);
    if (!options.contact_sheet.empty()) write_contact_sheet(options.contact_sheet, picture, rest, threads);
    if (!options.exposures.empty()) write_exposures(options.exposures, picture, luminance, rest, threads);
    if (std::holds_alternative<ZoneSystem>(rest.tone_mapper) && !options.quiet) {
        print_output(fmt::format("the picture spans {:.1f} zones\n", dynamic_range_zones(luminance)));
    }
    if (options.output.empty()) return;
    if (picture_format(options.output) == PictureFormat::png) {
        const Image<CodeRGB> codes = develop(picture, rest, threads).image;
        write_developed(options.output, codes, options.pipeline, options.png_level);
    } else {
        write_scene_referred(std::move(picture), rest, threads, options.output);
    }
}

}  // namespace

struct DevelopCommand::Options : DevelopSettings {};

DevelopCommand::DevelopCommand(CLI::App& program)
    : command_(program.add_subcommand("develop", "Develop a scene-referred picture to a PNG")),
      options_(std::make_unique<Options>()) {
    Options& options = *options_;
    add_file_options(*command_, options);
    add_threads_option(*command_, options.threads);
    command_->add_flag("--quiet", options.quiet, "No summary; warnings and errors only [default: a line]");
    add_pipeline_text_option(*command_, options.pipeline);
    add_pipeline_options(*command_, options.pipeline);
    add_display_options(*command_, options.pipeline);
    command_->add_flag("--show-pipeline", options.show_pipeline,
                       "Print the text of all stages with all their parameters, as --pipeline takes it, and end");
    command_->final_callback([&options] { check_settings(options); });
}

DevelopCommand::~DevelopCommand() = default;

bool DevelopCommand::chosen() const { return command_->parsed(); }

int DevelopCommand::run() const {
    const Options& options = *options_;
    if (options.list_tonemaps || options.list_adaptations) {
        if (options.list_tonemaps) print_output(tonemap_list());
        if (options.list_adaptations) print_output(adaptation_list());
        return kDone;
    }
    if (options.show_pipeline) {
        print_output(to_text(options.pipeline) + "\n");
        return kDone;
    }
    for (const auto& file : {options.output, options.contact_sheet, options.exposures, options.curve}) {
        if (!file.empty()) check_writable(file);
    }
    ScenePicture picture = read_picture(options.picture, options.threads);
    for (const std::string& note : picture.notes) print_warning(options.picture.string() + ": " + note);

    write_outputs(options, std::move(picture.xyz));
    for (const auto& file : {options.output, options.contact_sheet, options.exposures, options.curve}) {
        if (!file.empty() && !options.quiet) print_output(fmt::format("wrote {}\n", file.string()));
    }
    return kDone;
}

}  // namespace emulsion::cli
