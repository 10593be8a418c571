#include "cli/pipeline_options.h"

#include <utility>

#include <fmt/format.h>

#include "cli/messages.h"
#include "cli/named_option.h"
#include "develop/develop.h"
#include "display/png_file.h"

namespace emulsion::cli {

void add_pipeline_options(CLI::App& command, Pipeline& pipeline) {
    add_named_option(command, "--bloom", "bloom", pipeline.bloom, "Spreading of bright light before tone mapping");
    add_named_option(command, "--vision", "vision", pipeline.vision,
                     "Seeing as an eye on the spot, before tone mapping");
    add_named_option(command, "--tonemap", "tonemap", pipeline.tone_mapper, "Tone mapping operator of the PNG");
    add_named_option(command, "--adaptation", "adaptation", pipeline.adaptation,
                     "Luminance that the operator adapts to", "the operator's own");
}

PngOptions png_options(const Pipeline& pipeline, int level) {
    return {.bits = pipeline.bits,
            .color = color_encoding(pipeline.display, pipeline.transfer, pipeline.range),
            .level = level,
            .text = {{"Software", "Emulsion"}}};
}

void develop_to_png(Image<XYZ> scene, const Pipeline& pipeline, int threads, const std::filesystem::path& png,
                    int png_level) {
    const DevelopResult developed = develop(std::move(scene), pipeline, threads);
    const PixelCounts& counts = developed.report.luminance.counts;
    if (counts.bad() > 0) {
        const auto [x, y] = developed.report.luminance.first_bad_px.value_or(std::pair{0, 0});
        print_warning(fmt::format(
            "{} of {} pixels are bad ({} NaN, {} infinite, {} of negative luminance), the first at {}, {}",
            counts.bad(), developed.image.pixels().size(), counts.nan, counts.infinite, counts.negative, x, y));
    }
    PngOptions options = png_options(pipeline, png_level);
    options.text.push_back({"Pipeline", to_text(pipeline)});
    write_png(png, developed.image, options);
}

}  // namespace emulsion::cli
