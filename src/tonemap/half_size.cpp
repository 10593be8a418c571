#include "tonemap/half_size.h"

#include <cstddef>
#include <vector>

#include "core/row_blocks.h"
#include "tonemap/mirrored_border.h"

namespace emulsion {

namespace {

void half_row(ImageView<const float> source, int y, std::span<float> half) {
    const int width = source.width();
    const auto row = [&](int offset) { return source.row(mirrored(2 * y + offset, source.height())).data(); };
    const float *a = row(-1), *b = row(0), *c = row(1), *d = row(2);
    // One pixel more before the row, two more behind it.
    std::vector<float> columns(static_cast<std::size_t>(width) + 3);
    float* const first = columns.data() + 1;
    for (int x = 0; x < width; ++x) first[x] = (a[x] + d[x]) + 3.0f * (b[x] + c[x]);
    first[-1] = first[0];
    first[width] = first[mirrored(width, width)];
    first[width + 1] = first[mirrored(width + 1, width)];
    for (std::size_t x = 0; x < half.size(); ++x) {
        const float* const at = columns.data() + 2 * x;
        half[x] = 0x1p-6f * ((at[0] + at[3]) + 3.0f * (at[1] + at[2]));
    }
}

}  // namespace

Image<float> half_size(ImageView<const float> source, int threads) {
    Image<float> half((source.width() + 1) / 2, (source.height() + 1) / 2);
    parallel_for_rows(source.width(), half.height(), threads, [&](int y) { half_row(source, y, half.row(y)); });
    return half;
}

void double_row(ImageView<const float> half, int y, std::span<float> scratch, std::span<float> row) noexcept {
    const int width = half.width(), near = y / 2;
    const float* const nearer = half.row(near).data();
    const float* const farther = half.row(mirrored(y % 2 == 0 ? near - 1 : near + 1, half.height())).data();
    float* const first = scratch.data() + 1;
    for (int x = 0; x < width; ++x) first[x] = 0.75f * nearer[x] + 0.25f * farther[x];
    first[-1] = first[0];
    first[width] = first[width - 1];
    const std::size_t pairs = row.size() / 2;
    for (std::size_t x = 0; x < pairs; ++x) {
        row[2 * x] = 0.75f * first[x] + 0.25f * scratch[x];
        row[2 * x + 1] = 0.75f * first[x] + 0.25f * first[x + 1];
    }
    if (row.size() % 2 == 1) row[2 * pairs] = 0.75f * first[pairs] + 0.25f * scratch[pairs];
}

}  // namespace emulsion
