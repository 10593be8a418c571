#include "cli/tone_reports.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/pipeline_options.h"
#include "core/text_file.h"
#include "develop/contact_sheet.h"

namespace emulsion::cli {

namespace {

constexpr int kTile_px = 320;

/// `adapted_to` is left out if it is empty.
std::string block_of(const NamedValueDescription& value, std::string_view adapted_to) {
    std::string text = fmt::format("{}\n    {}\n", value.name, value.help);
    if (!adapted_to.empty()) text += fmt::format("    adapted to: {}\n", adapted_to);
    for (const ParameterDescription& parameter : value.parameters) {
        text += fmt::format("    {}  [default: {}; range: {}; unit: {}]\n        {}\n", parameter.name,
                            parameter.default_text, parameter.range_text,
                            parameter.unit.empty() ? "none" : parameter.unit, parameter.help);
    }
    return text;
}

/// The stages from tone mapping on.
Pipeline after_vision(Pipeline pipeline) {
    pipeline.bloom = NoBloom{};
    pipeline.vision = NoVision{};
    return pipeline;
}

}  // namespace

std::string tonemap_list() {
    std::vector<std::string> blocks;
    const std::vector<NamedValueDescription> operators = describe_named<ToneMapper>();
    for_each_alternative<ToneMapper>([&](const auto& mapper) {
        blocks.push_back(block_of(operators[blocks.size()], to_text(own_adaptation(mapper))));
    });
    return fmt::format("{}", fmt::join(blocks, "\n"));
}

std::string adaptation_list() {
    std::vector<std::string> blocks;
    for (const NamedValueDescription& value : describe_named<Adaptation>()) blocks.push_back(block_of(value, ""));
    return fmt::format("{}", fmt::join(blocks, "\n"));
}

void write_contact_sheet(const std::filesystem::path& png, const Image<XYZ>& picture, const Pipeline& pipeline,
                         int threads) {
    const std::vector<ContactTile> tiles = operator_tiles(pipeline.adaptation);
    write_developed(png, contact_sheet(picture, after_vision(pipeline), tiles, kTile_px, threads), pipeline);
}

void write_exposures(const std::filesystem::path& png, const Image<XYZ>& picture, const SceneLuminance& luminance,
                     const Pipeline& pipeline, int threads) {
    const auto* const fixed = std::get_if<FixedWhite>(&pipeline.tone_mapper);
    double white = 0.0;
    if (fixed != nullptr) {
        white = fixed->white / fixed->scale;
    } else {
        // Two digits, for labels that can be read and typed again.
        white = std::stod(fmt::format("{:.1e}", 0.1 * luminance.robust_max_cdm2()));
    }
    const std::vector<ContactTile> tiles = exposure_tiles(std::clamp(white, 1e-30, 1e30));
    write_developed(png, contact_sheet(picture, after_vision(pipeline), tiles, kTile_px, threads), pipeline);
}

void write_curve(const std::filesystem::path& csv, const Image<XYZ>& picture, const ToneMapping& mapping, int threads) {
    const Adaptation adaptation = mapping.adaptation ? *mapping.adaptation : own_adaptation(mapping.mapper);
    std::string text = fmt::format("# {} adapted to {}\n# display luminance 1 is display white\n",
                                   to_text(mapping.mapper), to_text(adaptation));
    if (is_local(adaptation))
        text += "# holds for large areas of a luminance: smaller ones depend on their surroundings\n";
    text += "luminance_cdm2,display_luminance\n";
    for (const CurvePoint& point : tone_curve(mapping, picture.view(), threads)) {
        text += fmt::format("{:.9g},{:.9g}\n", point.luminance_cdm2, point.display_luminance);
    }
    write_text_file(csv, text);
}

}  // namespace emulsion::cli
