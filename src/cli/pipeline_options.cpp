#include "cli/pipeline_options.h"

#include <stdexcept>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/messages.h"
#include "core/named_value.h"
#include "develop/develop.h"
#include "display/png_file.h"

namespace emulsion::cli {

namespace {

/// One line of help: the operators with their parameters, "reinhard-global[:key=0.18,white=inf]".
std::string tone_mapper_help() {
    std::string text = fmt::format("Tone mapping operator of the PNG, NAME[:parameter=value,...] [default: {}]; one of",
                                   to_text(ToneMapper{}));
    for (const NamedValueDescription& tone_mapper : describe_named<ToneMapper>()) {
        text += fmt::format("\n  {}: {}", tone_mapper.name, tone_mapper.help);
        for (const ParameterDescription& parameter : tone_mapper.parameters) {
            text += fmt::format("\n    {}={}  {}{}{}, in {}", parameter.name, parameter.default_text, parameter.help,
                                parameter.unit.empty() ? "" : ", ", parameter.unit, parameter.range_text);
        }
    }
    return text;
}

}  // namespace

void add_pipeline_options(CLI::App& command, Pipeline& pipeline) {
    command
        .add_option_function<std::string>(
            "--tonemap",
            [&pipeline](const std::string& text) {
                try {
                    pipeline.tone_mapper = parse_named<ToneMapper>(text, "tonemap");
                } catch (const std::invalid_argument& error) {
                    throw CLI::ValidationError("--tonemap", error.what());
                }
            },
            tone_mapper_help())
        ->option_text("NAME");
}

void develop_to_png(const Image<XYZ>& scene, const Pipeline& pipeline, int threads, const std::filesystem::path& png) {
    const DevelopResult developed = develop(scene, pipeline, threads);
    const PixelCounts& counts = developed.report.luminance.counts;
    if (counts.bad() > 0) {
        const auto [x, y] = developed.report.luminance.first_bad_px.value_or(std::pair{0, 0});
        print_warning(
            fmt::format("{} of {} pixels are bad ({} NaN, {} infinite, {} of negative luminance), the first at {}, {}",
                        counts.bad(), scene.pixels().size(), counts.nan, counts.infinite, counts.negative, x, y));
    }
    write_png(png, developed.image, {.text = {{"Software", "Emulsion"}, {"Pipeline", to_text(pipeline)}}});
}

}  // namespace emulsion::cli
