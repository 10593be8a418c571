#include "develop/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/row_blocks.h"
#include "develop/develop.h"
#include "display/label.h"

namespace emulsion {

namespace {

constexpr int kMargin_px = 8;
constexpr int kLabelScale = 2;
constexpr double kBackground = 38.0 / 255.0, kInk = 220.0 / 255.0;  // encoded

CodeRGB grey(double encoded, const CodeScale& scale) noexcept {
    const auto code = static_cast<std::uint16_t>(std::lround(scale.black + encoded * scale.steps()));
    return {code, code, code};
}

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

void paste(const Image<CodeRGB>& tile, int x, int y, Image<CodeRGB>& sheet) {
    for (int v = 0; v < tile.height(); ++v) {
        std::copy(tile.row(v).begin(), tile.row(v).end(), sheet.row(y + v).begin() + x);
    }
}

/// A row of up to four tiles; of more a sheet about half as high again as it is wide at most.
int columns_of(int count, int cell_width, int cell_height) noexcept {
    if (count <= 4) return count;
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(1.5 * count * cell_height / cell_width))), 1, count);
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

    std::size_t longest_label = 0;
    for (const ContactTile& tile : tiles) longest_label = std::max(longest_label, tile.label.size());
    const int label_width = static_cast<int>(longest_label) * kLabelAdvance_px * kLabelScale;
    const int cell_width = std::max(width, label_width) + kMargin_px;
    const int cell_height = height + kLabelHeight_px * kLabelScale + 2 * kMargin_px;
    const auto count = static_cast<int>(tiles.size());
    const int columns = columns_of(count, cell_width, cell_height);
    const int rows = (count + columns - 1) / columns;

    const CodeScale scale = code_scale(pipeline.bits, pipeline.range);
    Image<CodeRGB> sheet(columns * cell_width + kMargin_px, rows * cell_height + kMargin_px);
    std::fill(sheet.pixels().begin(), sheet.pixels().end(), grey(kBackground, scale));
    const XYZd white = shown_as_white(pipeline.white, pipeline.display);
    const XYZ display_white{static_cast<float>(white.x), static_cast<float>(white.y), static_cast<float>(white.z)};
    const std::optional<Image<XYZ>> before = before_tone_mapping(scene, pipeline, threads);
    const Image<XYZ>& picture = before ? *before : scene;
    for (int number = 0; number < count; ++number) {
        const auto& [mapping, label] = tiles[static_cast<std::size_t>(number)];
        const ToneMapResult mapped = tone_map(mapping, picture.view(), display_white, threads);
        const Image<XYZ> tile = averaged_down(mapped.image, width, height, threads);
        const int x = kMargin_px + number % columns * cell_width, y = kMargin_px + number / columns * cell_height;
        paste(develop_tone_mapped(tile, pipeline, threads).image, x, y, sheet);
        draw_label(sheet.view(), x, y + height + kMargin_px / 2, label, grey(kInk, scale), kLabelScale);
    }
    return sheet;
}

}  // namespace emulsion
