#include "cli/pipeline_options.h"

#include <stdexcept>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/measured_display.h"
#include "cli/messages.h"
#include "cli/named_option.h"
#include "cli/option_checks.h"
#include "core/error.h"
#include "core/text_file.h"
#include "develop/develop.h"
#include "display/png_file.h"

namespace emulsion::cli {

namespace {

/// Bad usage is what `check` throws.
template <class Check>
void check_stages(const Check& check) {
    try {
        check();
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("pipeline", error.what());
    }
}

}  // namespace

void add_pipeline_text_option(CLI::App& command, Pipeline& pipeline, std::string_view what) {
    const auto parse = [&pipeline](const std::string& argument) {
        const bool is_text = argument.find('=') != std::string::npos;
        try {
            pipeline = parse_pipeline(is_text ? argument : read_text_file(argument));
        } catch (const std::invalid_argument& error) {
            const std::string where = is_text ? "" : argument + ": ";
            throw CLI::ValidationError("--pipeline", where + error.what());
        } catch (const IoError& error) {
            throw CLI::ValidationError("--pipeline", error.what());
        }
    };
    command
        .add_option_function<std::string>(
            "--pipeline", parse,
            std::string(what) +
                ", as `develop --show-pipeline` prints them and a PNG's text has them: "
                "\"tonemap=drago display=hdr10 bits=10\", or the name of a file that holds such a text; what has an = "
                "is a "
                "text. Stages that are left out have their default")
        ->option_text("TEXT|FILE");
}

void add_pipeline_options(CLI::App& command, Pipeline& pipeline) {
    add_pipeline_text_option(command, pipeline,
                             "All stages of the PNG at once, before which flags of single stages go");
    add_named_option(command, "--bloom", "bloom", pipeline.bloom, "Spreading of bright light before tone mapping");
    add_named_option(command, "--vision", "vision", pipeline.vision,
                     "Seeing as an eye on the spot, before tone mapping");
    add_named_option(command, "--tonemap", "tonemap", pipeline.tone_mapper, "Tone mapping operator of the PNG");
    add_named_option(command, "--adaptation", "adaptation", pipeline.adaptation,
                     "Luminance that the operator adapts to", "the operator's");
}

void warn_of_bad_pixels(const LuminanceStatistics& statistics) {
    const PixelCounts& counts = statistics.counts;
    if (counts.bad() == 0) return;
    const auto [x, y] = statistics.first_bad_px.value_or(std::pair{0, 0});
    print_warning(fmt::format(
        "{} of {} pixels are bad ({} NaN, {} infinite, {} of negative luminance), the first at {}, {}", counts.bad(),
        counts.bad() + counts.positive + counts.zero, counts.nan, counts.infinite, counts.negative, x, y));
}

void add_display_options(CLI::App& command, Pipeline& pipeline) {
    add_named_option(command, "--scene-white", "scene-white", pipeline.scene_white,
                     "White of the scene, adapted to the display's");
    const CLI::Option* display =
        add_named_option(command, "--display", "display", pipeline.display, "Display that the PNG is for");
    add_primaries_options(command, *display, pipeline);
    add_named_option(command, "--gamut", "gamut", pipeline.gamut, "What is done with colours that it can't show");
    const CLI::Option* transfer = add_named_option(command, "--transfer", "transfer", pipeline.transfer,
                                                   "Transfer function of the codes", "the display's");
    add_transfer_table_option(command, *transfer, pipeline);
    command
        .add_option("--bits", pipeline.bits,
                    fmt::format("Bits of a code, 1 to 16; above 8 the PNG has 16 [default: {}]", pipeline.bits))
        ->check(whole_number_check(1, 16))
        ->option_text("N");
    add_named_option(command, "--range", "range", pipeline.range, "Range of the codes");
    add_named_option(command, "--dither", "dither", pipeline.dither, "Dithering of the codes");
}

void check_together(const Pipeline& pipeline) {
    check_stages([&] { validate(pipeline); });
}

void check_for_png(const Pipeline& pipeline) {
    check_stages([&] {
        validate(pipeline);
        validate(png_options(pipeline));
    });
}

PngOptions png_options(const Pipeline& pipeline, int level) {
    return {.bits = pipeline.bits,
            .color = color_encoding(pipeline.display, transfer_of(pipeline), pipeline.range),
            .level = level,
            .text = {{"Software", "Emulsion"}}};
}

void write_developed(const std::filesystem::path& png, const Image<CodeRGB>& image, const Pipeline& pipeline,
                     int png_level, const std::vector<PngText>& more) {
    PngOptions options = png_options(pipeline, png_level);
    options.text.push_back({"Pipeline", to_text(pipeline)});
    options.text.insert(options.text.end(), more.begin(), more.end());
    write_png(png, image, options);
}

void report_gamut(const DevelopResult& developed, const Pipeline& pipeline) {
    const GamutCounts& found = developed.report.gamut;
    const auto pixels = static_cast<double>(developed.image.pixels().size());
    if (found.uncoded > 0) {
        print_output(fmt::format(
            "{} of {} pixels ({:.2g} %) were too bright for their saturation: HLG has no code for "
            "them, they are shown at their luminance with less of it\n",
            found.uncoded, developed.image.pixels().size(), 100.0 * static_cast<double>(found.uncoded) / pixels));
    }
    if (found.outside == 0) return;
    print_output(
        fmt::format("{} of {} pixels ({:.2g} %) were outside the display's gamut, by up to {:.2g} of white; "
                    "--gamut {}\n",
                    found.outside, developed.image.pixels().size(), 100.0 * static_cast<double>(found.outside) / pixels,
                    found.largest_excess, to_text(pipeline.gamut)));
}

DevelopResult develop_to_png(const Image<XYZ>& scene, const Pipeline& pipeline, int threads,
                             const std::filesystem::path& png) {
    DevelopResult developed = develop(scene, pipeline, threads);
    warn_of_bad_pixels(developed.report.luminance);
    write_developed(png, developed.image, pipeline);
    return developed;
}

}  // namespace emulsion::cli
