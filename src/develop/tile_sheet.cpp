#include "develop/tile_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "display/display_encoder.h"
#include "display/label.h"

namespace emulsion {

namespace {

constexpr int kMargin_px = 8;
constexpr int kLabelScale = 2;
constexpr double kBackground = 38.0 / 255.0, kInk = 220.0 / 255.0;  // encoded, of sRGB

CodeRGB grey(double encoded, const CodeScale& scale) noexcept {
    const auto code = static_cast<std::uint16_t>(std::lround(scale.black + encoded * scale.steps()));
    return {code, code, code};
}

void paste(const Image<CodeRGB>& tile, int x, int y, Image<CodeRGB>& sheet) {
    for (int v = 0; v < tile.height(); ++v) {
        std::copy(tile.row(v).begin(), tile.row(v).end(), sheet.row(y + v).begin() + x);
    }
}

Image<CodeRGB> empty_sheet(const TileCell& cell, int count, int columns) {
    const int rows = (count + columns - 1) / columns;
    return {columns * cell.width + kMargin_px, rows * cell.height + kMargin_px};
}

}  // namespace

SheetGreys sheet_greys(const Pipeline& pipeline) {
    const CodeScale scale = code_scale(pipeline.bits, pipeline.range);
    const auto shown = [&](double srgb) {
        const double light = decode(SrgbTransfer{}, srgb);
        return grey(encode_signal(pipeline.display, transfer_of(pipeline), {light, light, light}).g, scale);
    };
    return {shown(kBackground), shown(kInk)};
}

SheetGreys sheet_greys(const CodeScale& scale) noexcept { return {grey(kBackground, scale), grey(kInk, scale)}; }

TileCell tile_cell(int width, int height, std::span<const std::string> labels) noexcept {
    std::size_t longest = 0;
    for (const std::string& label : labels) longest = std::max(longest, label.size());
    const int label_width = static_cast<int>(longest) * kLabelAdvance_px * kLabelScale;
    return {std::max(width, label_width) + kMargin_px, height + kLabelHeight_px * kLabelScale + 2 * kMargin_px};
}

TileSheet::TileSheet(int width, int height, std::vector<std::string> labels, int columns, const SheetGreys& greys)
    : labels_(std::move(labels)),
      cell_(tile_cell(width, height, labels_)),
      columns_(columns),
      tile_height_(height),
      ink_(greys.ink),
      sheet_(empty_sheet(cell_, static_cast<int>(labels_.size()), columns)) {
    std::fill(sheet_.pixels().begin(), sheet_.pixels().end(), greys.background);
}

void TileSheet::add(const Image<CodeRGB>& tile) {
    const auto number = static_cast<int>(next_);
    const int x = kMargin_px + number % columns_ * cell_.width, y = kMargin_px + number / columns_ * cell_.height;
    paste(tile, x, y, sheet_);
    draw_label(sheet_.view(), x, y + tile_height_ + kMargin_px / 2, labels_.at(next_++), ink_, kLabelScale);
}

}  // namespace emulsion
