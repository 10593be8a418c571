#include "cli/develop_command.h"

#include <filesystem>
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
#include "film/exr_file.h"

namespace emulsion::cli {

struct DevelopCommand::Options {
    std::filesystem::path exr, png, contact_sheet, exposures, curve;
    int threads = 0, png_level = kDefaultPngLevel;
    bool quiet = false, list_tonemaps = false, list_adaptations = false;
    Pipeline pipeline;
};

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
        ->add_option("--png-level", options.png_level,
                     fmt::format("Compression of the PNG, 0 (none) to 9 (smallest) [default: {}]; 6 is as libpng does "
                                 "it, the default as small on pictures and several times as fast",
                                 kDefaultPngLevel))
        ->check(whole_number_check(0, 9))
        ->option_text("N");
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
    check_png_options(options.pipeline);
    for (const auto& file : {options.png, options.contact_sheet, options.exposures, options.curve}) {
        if (!file.empty()) check_writable(file);
    }
    FilmImage picture = read_exr(options.exr, {.layers = ExrLayers::skip, .threads = options.threads});
    for (const std::string& note : picture.notes) print_warning(options.exr.string() + ": " + note);

    if (!options.curve.empty()) write_curve(options.curve, picture.xyz, options.pipeline, options.threads);
    if (!options.contact_sheet.empty()) {
        write_contact_sheet(options.contact_sheet, picture.xyz, options.pipeline, options.threads);
    }
    if (!options.exposures.empty()) {
        write_exposures(options.exposures, picture.xyz, options.pipeline, options.threads);
    }
    if (std::holds_alternative<ZoneSystem>(options.pipeline.tone_mapper) && !options.quiet) {
        const SceneLuminance luminance(picture.xyz.view(), options.threads);
        print_output(fmt::format("the picture spans {:.1f} zones\n", dynamic_range_zones(luminance)));
    }
    if (!options.png.empty())
        develop_to_png(std::move(picture.xyz), options.pipeline, options.threads, options.png, options.png_level);
    for (const auto& file : {options.png, options.contact_sheet, options.exposures, options.curve}) {
        if (!file.empty() && !options.quiet) print_output(fmt::format("wrote {}\n", file.string()));
    }
    return kDone;
}

}  // namespace emulsion::cli
