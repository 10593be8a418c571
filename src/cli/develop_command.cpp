#include "cli/develop_command.h"

#include <filesystem>
#include <optional>
#include <utility>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/distinct_files.h"
#include "cli/messages.h"
#include "cli/option_checks.h"
#include "cli/pipeline_options.h"
#include "cli/tone_reports.h"
#include "core/atomic_file.h"
#include "develop/develop.h"
#include "film/exr_file.h"

namespace emulsion::cli {

namespace {

struct DevelopSettings {
    std::filesystem::path exr, png, contact_sheet, exposures, curve;
    int threads = 0;
    bool quiet = false, list_tonemaps = false, list_adaptations = false;
    Pipeline pipeline;
};

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
    if (!options.png.empty()) {
        write_developed(options.png, develop(std::move(picture), rest, threads).image, options.pipeline);
    }
}

}  // namespace

struct DevelopCommand::Options : DevelopSettings {};

DevelopCommand::DevelopCommand(CLI::App& program)
    : command_(program.add_subcommand("develop", "Develop a scene-referred EXR to a PNG")),
      options_(std::make_unique<Options>()) {
    Options& options = *options_;
    command_->add_option("EXR", options.exr, "Picture with channels X Y Z or R G B, as `emulsion render` writes it")
        ->option_text(" ");
    command_->add_option("-o,--output", options.png, "8-bit sRGB PNG")->check(ends_in_png)->option_text("FILE");
    command_->add_option("--contact-sheet", options.contact_sheet, "PNG with a labelled tile for each operator")
        ->check(ends_in_png)
        ->option_text("FILE");
    command_
        ->add_option("--exposures", options.exposures,
                     "PNG strip of three exposures, with ten times the white of --tonemap fixed, with it, and with a "
                     "tenth of it; under another operator, around a tenth of the picture's bright end")
        ->check(ends_in_png)
        ->option_text("FILE");
    command_
        ->add_option("--curve", options.curve,
                     "CSV of the operator's luminance curve for this picture: cd/m^2, display luminance")
        ->option_text("FILE");
    command_->add_flag("--list-tonemaps", options.list_tonemaps, "Print every operator, and end");
    command_->add_flag("--list-adaptations", options.list_adaptations,
                       "Print every adaptation luminance that an operator may be given, and end");
    add_threads_option(*command_, options.threads);
    command_->add_flag("--quiet", options.quiet, "No summary; warnings and errors only [default: a line]");
    add_pipeline_options(*command_, options.pipeline);
    command_->final_callback([&options] {
        if (options.list_tonemaps || options.list_adaptations) return;
        if (options.exr.empty()) throw CLI::ValidationError("EXR", "found none, expected a file");
        if (options.png.empty() && options.contact_sheet.empty() && options.exposures.empty() &&
            options.curve.empty()) {
            throw CLI::ValidationError("--output", "found none, expected it, --contact-sheet, --exposures or --curve");
        }
        require_distinct({{"EXR", options.exr},
                          {"--output", options.png},
                          {"--contact-sheet", options.contact_sheet},
                          {"--exposures", options.exposures},
                          {"--curve", options.curve}});
    });
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
    for (const auto& file : {options.png, options.contact_sheet, options.exposures, options.curve}) {
        if (!file.empty()) check_writable(file);
    }
    FilmImage picture = read_exr(options.exr, {.layers = ExrLayers::skip, .threads = options.threads});
    for (const std::string& note : picture.notes) print_warning(options.exr.string() + ": " + note);

    write_outputs(options, std::move(picture.xyz));
    for (const auto& file : {options.png, options.contact_sheet, options.exposures, options.curve}) {
        if (!file.empty() && !options.quiet) print_output(fmt::format("wrote {}\n", file.string()));
    }
    return kDone;
}

}  // namespace emulsion::cli
