#include "compare/difference_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "compare/difference_ramp.h"
#include "display/label.h"

namespace emulsion {

namespace {

constexpr CodeRGB kBackground{34, 34, 34}, kInk{222, 222, 222}, kLeftOut{128, 128, 128};

/// Where things are below the map, in pixels.
struct Layout {
    int letter;  ///< scale of the letters
    int width;   ///< of the whole picture
    int margin;  ///< around scale and text
    int bar_height;
    int text_height;  ///< of a line, with the gap above it

    [[nodiscard]] int bar_width() const noexcept { return width - 2 * margin; }
};

int text_width(const std::string& text, int letter) noexcept {
    return (static_cast<int>(text.size()) * kLabelAdvance_px - 1) * letter;
}

/// Lines of text that are wider than the map make the whole picture wider.
Layout layout_of(int map_width, const std::vector<std::string>& lines) noexcept {
    constexpr int kLetterEvery_px = 360, kLeastBar_px = 150;
    const int letter = std::max(1, (map_width + kLetterEvery_px / 2) / kLetterEvery_px);
    int inside = kLeastBar_px * letter;
    for (const std::string& line : lines) inside = std::max(inside, text_width(line, letter));
    const int margin = 6 * letter;
    return {letter, std::max(map_width, inside + 2 * margin), margin, 10 * letter, (kLabelHeight_px + 3) * letter};
}

void fill(ImageView<CodeRGB> picture, int x0, int y0, int width, int height, const CodeRGB& color) noexcept {
    for (int y = y0; y < y0 + height; ++y) {
        for (int x = x0; x < x0 + width; ++x) picture(x, y) = color;
    }
}

void draw_pixels(const Image<double>& differences, double end, const DifferenceRamp& ramp,
                 ImageView<CodeRGB> picture) noexcept {
    for (int y = 0; y < differences.height(); ++y) {
        for (int x = 0; x < differences.width(); ++x) {
            const double difference = differences(x, y);
            picture(x, y) = std::isnan(difference) ? kLeftOut : ramp.code(difference / end);
        }
    }
}

/// Into how many the scale is divided, for round numbers.
int parts_of(double end) {
    switch (fmt::format("{:e}", end).front()) {
        case '2':
            return 4;
        case '3':
            return 3;
        default:
            return 5;
    }
}

/// The bar, a mark at each number, and the numbers; all of it from row y0 on.
void draw_scale(double end, const DifferenceRamp& ramp, const Layout& layout, int y0, ImageView<CodeRGB> picture) {
    const int last = layout.bar_width() - 1;
    for (int i = 0; i <= last; ++i) {
        fill(picture, layout.margin + i, y0, 1, layout.bar_height, ramp.code(static_cast<double>(i) / last));
    }
    const int parts = parts_of(end);
    for (int part = 0; part <= parts; ++part) {
        const int x = layout.margin + (last * part + parts / 2) / parts;
        const std::string number = fmt::format("{:.3g}{}", end * part / parts, part == parts ? "+" : "");
        fill(picture, x, y0 + layout.bar_height, 1, 2 * layout.letter, kInk);
        const int width = text_width(number, layout.letter);
        const int left = std::clamp(x - width / 2, layout.margin, layout.margin + last + 1 - width);
        draw_label(picture, left, y0 + layout.bar_height + 3 * layout.letter, number, kInk, layout.letter);
    }
}

}  // namespace

double scale_end(const DifferenceStatistics& statistics) noexcept {
    for (double decade = 1.0;; decade *= 10.0) {
        for (const double end : {decade, 2.0 * decade, 3.0 * decade, 5.0 * decade}) {
            if (!(statistics.p99 > end)) return end;
        }
    }
}

Image<CodeRGB> difference_map(const Image<double>& differences, const DifferenceStatistics& statistics,
                              const DifferenceMapOptions& options) {
    const double end = options.end.value_or(scale_end(statistics));
    if (!(end > 0.0) || !std::isfinite(end)) {
        throw std::invalid_argument(fmt::format("end of the scale {}: must be finite and > 0", end));
    }
    std::vector<std::string> lines = {
        fmt::format("{}: mean {:.3g}, p99 {:.3g}", options.name, statistics.mean, statistics.p99),
        fmt::format("max {:.3g} at {}, {}", statistics.max, statistics.max_x, statistics.max_y)};
    if (statistics.pixels < static_cast<std::int64_t>(differences.pixels().size())) {
        lines.emplace_back("grey: not finite");
    }
    const Layout layout = layout_of(differences.width(), lines);
    const int scale_height = layout.bar_height + 3 * layout.letter + layout.text_height;
    const int below = 2 * layout.margin + scale_height + static_cast<int>(lines.size()) * layout.text_height;

    Image<CodeRGB> picture(layout.width, differences.height() + below);
    std::ranges::fill(picture.pixels(), kBackground);
    const DifferenceRamp ramp;
    draw_pixels(differences, end, ramp, picture.view());
    int y = differences.height() + layout.margin;
    draw_scale(end, ramp, layout, y, picture.view());
    y += scale_height;
    for (const std::string& line : lines) {
        draw_label(picture.view(), layout.margin, y, line, kInk, layout.letter);
        y += layout.text_height;
    }
    return picture;
}

}  // namespace emulsion
