#include <algorithm>
#include <initializer_list>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/develop_settings.h"
#include "cli/named_option.h"
#include "cli/option_checks.h"
#include "cli/picture_output.h"
#include "cli/pipeline_options.h"
#include "cli/precision_option.h"

// The flags of `emulsion develop`, by what they are about.

namespace emulsion::cli {

namespace {

void add_picture_options(CLI::App& command, DevelopSettings& settings) {
    command
        .add_option(
            "PICTURE", settings.picture,
            "EXR with channels X Y Z or R G B, as `emulsion render` writes it; or a Radiance picture, a PFM, or "
            "a PNG whose white is 1 cd/m^2: by its contents, not by its name")
        ->option_text(" ");
    command
        .add_option("-o,--output", settings.output,
                    "PNG; or a name ending in .pfm or .hdr for the picture as tone mapping would get it, after --bloom "
                    "and --vision: linear Rec. 709, (1, 1, 1) for a white of 1 cd/m^2")
        ->check(ends_in_picture)
        ->option_text("FILE");
    command
        .add_option("--png-level", settings.png_level,
                    fmt::format("Compression of the PNG, 0 (none) to 9 (smallest) [default: {}]; 6 is as libpng does "
                                "it, the default as small on pictures and several times as fast",
                                kDefaultPngLevel))
        ->check(whole_number_check(0, 9))
        ->option_text("N");
}

void add_choice_options(CLI::App& command, DevelopSettings& settings) {
    command.add_option("--contact-sheet", settings.contact_sheet, "PNG with a labelled tile for each operator")
        ->check(ends_in_png)
        ->option_text("FILE");
    command
        .add_option("--exposures", settings.exposures,
                    "PNG strip of three exposures, with ten times the white of --tonemap fixed, with it, and with a "
                    "tenth of it; under another operator, around a tenth of the picture's bright end")
        ->check(ends_in_png)
        ->option_text("FILE");
    command
        .add_option("--curve", settings.curve,
                    "CSV of the operator's luminance curve for this picture (local ones: of large areas): cd/m^2, "
                    "display luminance")
        ->option_text("FILE");
    command.add_flag("--list-tonemaps", settings.list_tonemaps, "Print every operator, and end");
    command.add_flag("--list-adaptations", settings.list_adaptations,
                     "Print every adaptation luminance that an operator may be given, and end");
}

void add_print_options(CLI::App& command, DevelopSettings& settings) {
    command
        .add_option("--plates", settings.plates,
                    "PNG of the plates of a print, four labelled tiles: cyan, magenta, yellow and black ink, each dark "
                    "where there is ink, in the codes of --bits and --dither (halftone:screens=plates turns them)")
        ->check(ends_in_png)
        ->option_text("FILE");
    command.add_option("--print-preview", settings.print_preview, "PNG of these plates over one another")
        ->check(ends_in_png)
        ->option_text("FILE");
    add_named_option(command, "--black", "black", settings.black, "Black ink of the plates");
}

/// Flags for what none of the files asked for has would be left out in silence.
void refuse_idle_flags(const CLI::App& command, const DevelopSettings& settings, bool writes_png) {
    const auto refuse = [&](std::initializer_list<const char*> flags, const char* expected) {
        for (const char* flag : flags) {
            if (command.count(flag) > 0) throw CLI::ValidationError(flag, expected);
        }
    };
    if (!writes_png) {
        refuse({"--scene-white", "--display", "--primaries", "--white", "--gamut", "--transfer", "--transfer-table",
                "--bits", "--range", "--dither", "--png-level"},
               "found without a PNG to write, expected -o FILE.png or another output that is one");
        if (settings.curve.empty()) {
            refuse({"--tonemap", "--adaptation"}, "found without a PNG or --curve to write, expected one of them");
        }
    }
    if (settings.plates.empty() && settings.print_preview.empty()) {
        refuse({"--black"}, "found alone, expected --plates or --print-preview");
    }
}

/// What only all flags together can tell.
void check_settings(const CLI::App& command, const DevelopSettings& settings) {
    if (settings.list_tonemaps || settings.list_adaptations) return;
    const std::vector<NamedFile> outputs = output_files(settings);
    const auto is_png = [](const NamedFile& file) { return ends_in_png(file.path).empty(); };
    const bool writes_png = std::any_of(outputs.begin(), outputs.end(), is_png);
    if (!outputs.empty()) refuse_idle_flags(command, settings, writes_png);
    if (writes_png) {
        check_for_png(settings.pipeline);
    } else {
        check_together(settings.pipeline);
    }
    if (settings.auto_precision && (settings.show_pipeline || !writes_png)) {
        throw CLI::ValidationError("--precision", "found auto without a PNG to write, expected fast or reference");
    }
    if (settings.show_pipeline) return;
    if (settings.picture.empty()) throw CLI::ValidationError("PICTURE", "found none, expected a file");
    if (outputs.empty()) {
        throw CLI::ValidationError(
            "--output", "found none, expected it, --contact-sheet, --exposures, --plates, --print-preview or --curve");
    }
    std::vector<NamedFile> files = {{"PICTURE", settings.picture}};
    files.insert(files.end(), outputs.begin(), outputs.end());
    require_distinct(files);
}

}  // namespace

void add_develop_options(CLI::App& command, DevelopSettings& settings) {
    add_picture_options(command, settings);
    add_choice_options(command, settings);
    add_print_options(command, settings);
    add_threads_option(command, settings.threads);
    command.add_flag("--quiet", settings.quiet, "No summary; warnings and errors only [default: a line]");
    add_pipeline_options(command, settings.pipeline);
    add_precision_option(command, settings);
    add_display_options(command, settings.pipeline);
    command.add_flag("--show-pipeline", settings.show_pipeline,
                     "Print the text of all stages with all their parameters, as --pipeline takes it, and end");
    command.final_callback([&command, &settings] { check_settings(command, settings); });
}

std::vector<NamedFile> output_files(const DevelopSettings& settings) {
    std::vector<NamedFile> files = {
        {"--output", settings.output}, {"--contact-sheet", settings.contact_sheet}, {"--exposures", settings.exposures},
        {"--plates", settings.plates}, {"--print-preview", settings.print_preview}, {"--curve", settings.curve}};
    std::erase_if(files, [](const NamedFile& file) { return file.path.empty(); });
    return files;
}

}  // namespace emulsion::cli
