#include "cli/tone_reports.h"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "cli/pipeline_options.h"
#include "core/text_file.h"
#include "develop/contact_sheet.h"
#include "develop/develop.h"
#include "display/png_file.h"
#include "tonemap/tone_mapper.h"

namespace emulsion::cli {

namespace {

constexpr int kTile_px = 320;

template <NamedVariant Variant>
std::string blocks_of() {
    std::string text;
    for (const NamedValueDescription& value : describe_named<Variant>()) {
        if (!text.empty()) text += '\n';
        text += fmt::format("{}\n    {}\n", value.name, value.help);
        for (const ParameterDescription& parameter : value.parameters) {
            text += fmt::format("    {}  [default: {}; range: {}{}{}]\n        {}\n", parameter.name,
                                parameter.default_text, parameter.range_text,
                                parameter.unit.empty() ? "" : "; unit: ", parameter.unit, parameter.help);
        }
    }
    return text;
}

}  // namespace

std::string tonemap_list() { return blocks_of<ToneMapper>(); }

std::string adaptation_list() { return blocks_of<Adaptation>(); }

void write_contact_sheet(const std::filesystem::path& png, const Image<XYZ>& scene, const Pipeline& pipeline,
                         int threads) {
    write_png(png, contact_sheet(scene, pipeline, operator_tiles(), kTile_px, threads), png_options(pipeline));
}

void write_exposures(const std::filesystem::path& png, const Image<XYZ>& scene, const Pipeline& pipeline, int threads) {
    const auto* const fixed = std::get_if<FixedWhite>(&pipeline.tone_mapper);
    double white = 0.0;
    if (fixed != nullptr) {
        white = fixed->white / fixed->scale;
    } else {
        // Two digits, for labels that can be read and typed again.
        const double most = SceneLuminance(scene.view(), threads).robust_max_cdm2();
        white = std::stod(fmt::format("{:.1e}", 0.1 * most));
    }
    const std::vector<ContactTile> tiles = exposure_tiles(std::clamp(white, 1e-30, 1e30));
    write_png(png, contact_sheet(scene, pipeline, tiles, kTile_px, threads), png_options(pipeline));
}

void write_curve(const std::filesystem::path& csv, const Image<XYZ>& scene, const Pipeline& pipeline, int threads) {
    const std::optional<Image<XYZ>> picture = before_tone_mapping(scene, pipeline, threads);
    const ToneMapping mapping{pipeline.tone_mapper, pipeline.adaptation};
    std::string text =
        fmt::format("# {} adapted to {}\n# display luminance 1 is display white\n", to_text(mapping.mapper),
                    to_text(mapping.adaptation ? *mapping.adaptation : own_adaptation(mapping.mapper)));
    text += "luminance_cdm2,display_luminance\n";
    for (const CurvePoint& point : tone_curve(mapping, (picture ? *picture : scene).view(), threads)) {
        text += fmt::format("{:.9g},{:.9g}\n", point.luminance_cdm2, point.display_luminance);
    }
    write_text_file(csv, text);
}

}  // namespace emulsion::cli
