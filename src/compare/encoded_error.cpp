#include "compare/encoded_error.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "compare/finite_pixel.h"
#include "core/row_blocks.h"
#include "develop/develop.h"
#include "develop/picture_encoder.h"

namespace emulsion {

namespace {

double squared_error(const RGB& a, const RGB& b) noexcept {
    const auto squared = [](float first, float second) {
        const double difference = double{unit_clamp(second)} - double{unit_clamp(first)};
        return difference * difference;
    };
    return (squared(a.r, b.r) + squared(a.g, b.g) + squared(a.b, b.b)) / 3.0;
}

}  // namespace

double encoded_psnr_db(const Image<XYZ>& a, const Image<XYZ>& b, const Pipeline& pipeline, int threads) {
    validate(pipeline);
    const std::optional<Image<XYZ>> staged_a = before_tone_mapping(a, pipeline, threads),
                                    staged_b = before_tone_mapping(b, pipeline, threads);
    const ImageView<const XYZ> scene_a = staged_a ? staged_a->view() : a.view(),
                               scene_b = staged_b ? staged_b->view() : b.view();
    const PreparedToneMapping map_a = prepare_tone_mapping(pipeline, scene_a, threads);
    const PreparedToneMapping map_b = prepare_tone_mapping_as_other(pipeline, scene_b, scene_a, threads);
    PictureEncoder encode_a(a.height(), std::cref(map_a), pipeline), encode_b(b.height(), std::cref(map_b), pipeline);

    struct RowError {
        double squared = 0.0;
        std::int64_t pixels = 0;
    };
    std::vector<RowError> rows(static_cast<std::size_t>(a.height()));
    parallel_for_rows(a.width(), a.height(), threads, [&](int y) {
        std::vector<RGB> encoded_a(static_cast<std::size_t>(a.width())), encoded_b(encoded_a.size());
        encode_a(y, 0, encoded_a);
        encode_b(y, 0, encoded_b);
        RowError& row = rows[static_cast<std::size_t>(y)];
        for (std::size_t x = 0; x < encoded_a.size(); ++x) {
            if (!is_finite(a.row(y)[x]) || !is_finite(b.row(y)[x])) continue;
            row.squared += squared_error(encoded_a[x], encoded_b[x]);
            ++row.pixels;
        }
    });
    RowError total;
    for (const RowError& row : rows) {
        total.squared += row.squared;
        total.pixels += row.pixels;
    }
    return 10.0 * std::log10(static_cast<double>(total.pixels) / total.squared);
}

}  // namespace emulsion
