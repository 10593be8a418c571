#include "develop/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/row_blocks.h"
#include "develop/develop.h"
#include "develop/tile_sheet.h"

namespace emulsion {

namespace {

/// The pixel range [begin, end) of `size` that the pixel `i` of `smaller` stands for.
std::pair<int, int> stretch(int i, int smaller, int size) noexcept {
    const auto edge = [&](int at) { return static_cast<int>(std::int64_t{size} * at / smaller); };
    return {edge(i), edge(i + 1)};
}

/// The mean of each stretch of pixels, each of them no brighter than display white, as it will be shown.
Image<XYZ> averaged_down(const Image<XYZ>& display, int width, int height, int threads) {
    Image<XYZ> smaller(width, height);
    parallel_for_rows(width, height, threads, [&](int y) {
        const auto [y0, y1] = stretch(y, height, display.height());
        for (int x = 0; x < width; ++x) {
            const auto [x0, x1] = stretch(x, width, display.width());
            XYZ sum;
            for (int v = y0; v < y1; ++v) {
                for (int u = x0; u < x1; ++u) {
                    const XYZ& pixel = display(u, v);
                    sum = sum + 1.0f / std::max(1.0f, pixel.y) * pixel;
                }
            }
            smaller(x, y) = 1.0f / static_cast<float>((x1 - x0) * (y1 - y0)) * sum;
        }
    });
    return smaller;
}

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
    const double shrink = std::min(1.0, double(tile_px) / std::max({scene.width(), scene.height(), 1}));
    const int width = std::max(1, static_cast<int>(std::lround(shrink * scene.width())));
    const int height = std::max(1, static_cast<int>(std::lround(shrink * scene.height())));

    std::vector<std::string> labels;
    for (const ContactTile& tile : tiles) labels.push_back(tile.label);
    const int columns = columns_of(static_cast<int>(tiles.size()), tile_cell(width, height, labels));
    TileSheet sheet(width, height, std::move(labels), columns, sheet_greys(pipeline));
    const XYZd white = shown_as_white(pipeline.scene_white, pipeline.display);
    const XYZ display_white{static_cast<float>(white.x), static_cast<float>(white.y), static_cast<float>(white.z)};
    const std::optional<Image<XYZ>> before = before_tone_mapping(scene, pipeline, threads);
    const Image<XYZ>& picture = before ? *before : scene;
    for (const ContactTile& tile : tiles) {
        const ToneMapResult mapped = tone_map(tile.mapping, picture.view(), display_white, threads);
        sheet.add(develop_tone_mapped(averaged_down(mapped.image, width, height, threads), pipeline, threads).image);
    }
    return std::move(sheet).picture();
}

}  // namespace emulsion
