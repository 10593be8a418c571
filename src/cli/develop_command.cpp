#include "cli/develop_command.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/develop_settings.h"
#include "cli/messages.h"
#include "cli/picture_output.h"
#include "cli/pipeline_options.h"
#include "cli/precision_option.h"
#include "cli/tone_reports.h"
#include "core/atomic_file.h"
#include "develop/develop.h"
#include "develop/picture_file.h"
#include "develop/print_preview.h"

namespace emulsion::cli {

namespace {

/// Of the picture after bloom and vision; `rest` are the other stages.
void write_print_previews(const DevelopSettings& settings, const Image<XYZ>& picture, const Pipeline& rest) {
    if (settings.plates.empty() && settings.print_preview.empty()) return;
    const PrintPlates plates = print_plates(picture, rest, settings.black, settings.threads);
    const PngText black{"Black ink", to_text(settings.black)};
    const auto write = [&](const std::filesystem::path& png, const Image<CodeRGB>& codes) {
        write_developed(png, codes, settings.pipeline, settings.png_level, {black});
    };
    if (!settings.plates.empty()) write(settings.plates, plate_sheet(plates));
    if (!settings.print_preview.empty()) write(settings.print_preview, composite(plates, settings.threads));
}

/// The stages before tone mapping are gone through once, for all outputs.
void write_outputs(const DevelopSettings& settings, Image<XYZ> picture) {
    const int threads = settings.threads;
    Pipeline rest = settings.pipeline;
    if (std::optional<Image<XYZ>> before = before_tone_mapping(picture, rest, threads)) picture = std::move(*before);
    rest.bloom = NoBloom{};
    rest.vision = NoVision{};
    const SceneLuminance luminance(picture.view(), threads);
    warn_of_bad_pixels(luminance.statistics());

    if (!settings.curve.empty()) write_curve(settings.curve, picture, {rest.tone_mapper, rest.adaptation}, threads);
    if (!settings.contact_sheet.empty())
        write_contact_sheet(settings.contact_sheet, picture, settings.pipeline, threads);
    if (!settings.exposures.empty())
        write_exposures(settings.exposures, picture, luminance, settings.pipeline, threads);
    write_print_previews(settings, picture, rest);
    if (std::holds_alternative<ZoneSystem>(rest.tone_mapper) && !settings.quiet) {
        print_output(fmt::format("the picture spans {:.1f} zones\n", dynamic_range_zones(luminance)));
    }
    if (settings.output.empty()) return;
    if (picture_format(settings.output) == PictureFormat::png) {
        const DevelopResult developed = develop(picture, rest, threads);
        write_developed(settings.output, developed.image, settings.pipeline, settings.png_level);
        if (!settings.quiet) report_gamut(developed, rest);
    } else {
        write_scene_referred(picture, settings.output);
    }
}

}  // namespace

struct DevelopCommand::Options : DevelopSettings {};

DevelopCommand::DevelopCommand(CLI::App& program)
    : command_(program.add_subcommand("develop", "Develop a scene-referred picture to a PNG")),
      options_(std::make_unique<Options>()) {
    add_develop_options(*command_, *options_);
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
    const std::vector<NamedFile> outputs = output_files(options);
    for (const NamedFile& file : outputs) check_writable(file.path);
    ScenePicture picture = read_picture(options.picture, options.threads);
    for (const std::string& note : picture.notes) print_warning(options.picture.string() + ": " + note);

    DevelopSettings settings = options;
    resolve_precision(picture.xyz, settings);
    write_outputs(settings, std::move(picture.xyz));
    if (options.quiet) return kDone;
    for (const NamedFile& file : outputs) print_output(fmt::format("wrote {}\n", file.path.string()));
    return kDone;
}

}  // namespace emulsion::cli
