#include "develop/print_preview.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "core/row_blocks.h"
#include "develop/develop.h"
#include "develop/picture_encoder.h"
#include "develop/tile_sheet.h"

namespace emulsion {

namespace {

/// What the inks leave, as encoded values; those of cyan, magenta and yellow are the components.
struct EncodedPlates {
    Image<RGB> cmy;
    Image<float> black;
};

/// The stages from tone mapping to the separation, row by row.
EncodedPlates separated(const Image<XYZ>& scene, const Pipeline& pipeline, const BlackGeneration& black, int threads) {
    const std::optional<Image<XYZ>> before = before_tone_mapping(scene, pipeline, threads);
    const PreparedToneMapping map = prepare_tone_mapping(pipeline, (before ? *before : scene).view(), threads);
    PictureEncoder encode(scene.height(), std::cref(map), pipeline);
    EncodedPlates plates{Image<RGB>(scene.width(), scene.height()), Image<float>(scene.width(), scene.height())};
    parallel_for_rows(scene.width(), scene.height(), threads, [&](int y) {
        const std::span<RGB> row = plates.cmy.row(y);
        encode(y, 0, row);
        std::vector<Inks> inks(row.size());
        separate(black, row, inks);
        for (std::size_t x = 0; x < row.size(); ++x) {
            row[x] = {1.0f - inks[x].c, 1.0f - inks[x].m, 1.0f - inks[x].y};
            plates.black.row(y)[x] = 1.0f - inks[x].k;
        }
    });
    return plates;
}

template <class Pixel>
void turn_upside_down(Image<Pixel>& image) {
    for (int y = 0; y < image.height() / 2; ++y) {
        std::ranges::swap_ranges(image.row(y), image.row(image.height() - 1 - y));
    }
}

/// One plate in grey.
template <class CodeAt>
Image<CodeRGB> grey_tile(int width, int height, const CodeAt& code_at) {
    Image<CodeRGB> tile(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint16_t code = code_at(x, y);
            tile(x, y) = {code, code, code};
        }
    }
    return tile;
}

}  // namespace

PrintPlates print_plates(const Image<XYZ>& scene, const Pipeline& pipeline, const BlackGeneration& black, int threads) {
    validate(pipeline);
    validate_named(black, "black");
    EncodedPlates encoded = separated(scene, pipeline, black, threads);
    const CodeScale scale = code_scale(pipeline.bits, pipeline.range);

    const bool turns = !std::holds_alternative<Halftone>(pipeline.dither);
    if (turns) turn_upside_down(encoded.black);
    PrintPlates plates{quantize(pipeline.dither, std::as_const(encoded.cmy).view(), scale, threads),
                       quantize(pipeline.dither, std::as_const(encoded.black).view(), scale, threads), scale};
    if (turns) turn_upside_down(plates.black);
    return plates;
}

Image<CodeRGB> composite(const PrintPlates& plates, int threads) {
    const auto black = static_cast<std::uint32_t>(plates.scale.black);
    const auto steps = static_cast<std::uint32_t>(plates.scale.steps());
    Image<CodeRGB> picture(plates.cmy.width(), plates.cmy.height());
    parallel_for_rows(picture.width(), picture.height(), threads, [&](int y) {
        for (int x = 0; x < picture.width(); ++x) {
            const std::uint32_t left = plates.black(x, y) - black;
            const auto over = [&](std::uint16_t ink) {
                return static_cast<std::uint16_t>(black + ((ink - black) * left + steps / 2) / steps);
            };
            const CodeRGB& inks = plates.cmy(x, y);
            picture(x, y) = {over(inks.r), over(inks.g), over(inks.b)};
        }
    });
    return picture;
}

Image<CodeRGB> plate_sheet(const PrintPlates& plates) {
    const int width = plates.cmy.width(), height = plates.cmy.height();
    TileSheet sheet(width, height, {"cyan", "magenta", "yellow", "black"}, 2, sheet_greys(plates.scale));
    for (const auto component : {&CodeRGB::r, &CodeRGB::g, &CodeRGB::b}) {
        sheet.add(grey_tile(width, height, [&](int x, int y) { return plates.cmy(x, y).*component; }));
    }
    sheet.add(grey_tile(width, height, [&](int x, int y) { return plates.black(x, y); }));
    return std::move(sheet).picture();
}

}  // namespace emulsion
