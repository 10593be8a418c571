#include "develop/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "develop/averaged_down.h"
#include "develop/develop.h"
#include "develop/tile_sheet.h"

namespace emulsion {

namespace {

/// No brighter than display white, as it will be shown.
std::optional<XYZ> as_shown(const XYZ& pixel) noexcept { return 1.0f / std::max(1.0f, pixel.y) * pixel; }

/// A row of up to four tiles; of more a sheet about half as high again as it is wide at most.
int columns_of(int count, const TileCell& cell) noexcept {
    if (count <= 4) return count;
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(1.5 * count * cell.height / cell.width))), 1, count);
}

}  // namespace

std::vector<ContactTile> operator_tiles(const std::optional<Adaptation>& adaptation) {
    std::vector<ContactTile> tiles;
    for_each_alternative<ToneMapper>([&](const auto& mapper) {
        tiles.push_back({{.mapper = mapper, .adaptation = adaptation}, std::string(mapper.kName)});
    });
    return tiles;
}

std::vector<ContactTile> exposure_tiles(double white_cdm2) {
    check_range(white_cdm2, {1e-30, 1e30}, "white_cdm2");
    std::vector<ContactTile> tiles;
    for (const double times : {10.0, 1.0, 0.1}) {
        const FixedWhite fixed{.white = static_cast<float>(times * white_cdm2)};
        // Without the scale, which is 1: a label that is wider than its tile would leave a gap beside it.
        tiles.push_back({{.mapper = fixed}, std::string(FixedWhite::kName) + ":white=" + number_text(fixed.white)});
    }
    return tiles;
}

Image<CodeRGB> contact_sheet(const Image<XYZ>& scene, const Pipeline& pipeline, std::span<const ContactTile> tiles,
                             int tile_px, int threads) {
    check_range(tile_px, {16.0, 4096.0}, "tile_px");
    if (tiles.empty()) throw std::invalid_argument("tiles: found none, expected one or more");
    validate(pipeline);
    for (const ContactTile& tile : tiles) validate(tile.mapping);
    const auto [width, height] = size_within(scene.width(), scene.height(), tile_px);

    std::vector<std::string> labels;
    for (const ContactTile& tile : tiles) labels.push_back(tile.label);
    const int columns = columns_of(static_cast<int>(tiles.size()), tile_cell(width, height, labels));
    TileSheet sheet(width, height, std::move(labels), columns, sheet_greys(pipeline));
    const std::optional<Image<XYZ>> before = before_tone_mapping(scene, pipeline, threads);
    Pipeline rest = pipeline;
    rest.bloom = NoBloom{};
    rest.vision = NoVision{};
    for (const ContactTile& tile : tiles) {
        rest.tone_mapper = tile.mapping.mapper;
        rest.adaptation = tile.mapping.adaptation;
        const Image<XYZ> mapped = tone_mapped(before ? *before : scene, rest, threads);
        sheet.add(develop_tone_mapped(averaged_down(mapped, width, height, threads, as_shown), rest, threads).image);
    }
    return std::move(sheet).picture();
}

}  // namespace emulsion
