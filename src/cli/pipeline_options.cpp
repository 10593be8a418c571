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

void warn_of_bad_pixels(const LuminanceStatistics& statistics) {
    const PixelCounts& counts = statistics.counts;
    if (counts.bad() == 0) return;
    const auto [x, y] = statistics.first_bad_px.value_or(std::pair{0, 0});
    print_warning(fmt::format(
        "{} of {} pixels are bad ({} NaN, {} infinite, {} of negative luminance), the first at {}, {}", counts.bad(),
        counts.bad() + counts.positive + counts.zero, counts.nan, counts.infinite, counts.negative, x, y));
}

void write_developed(const std::filesystem::path& png, const Image<CodeRGB>& image, const Pipeline& pipeline) {
    write_png(png, image,
              {.bits = pipeline.bits, .text = {{"Software", "Emulsion"}, {"Pipeline", to_text(pipeline)}}});
}

void develop_to_png(Image<XYZ> scene, const Pipeline& pipeline, int threads, const std::filesystem::path& png) {
    const DevelopResult developed = develop(std::move(scene), pipeline, threads);
    warn_of_bad_pixels(developed.report.luminance);
    write_developed(png, developed.image, pipeline);
}

}  // namespace emulsion::cli
