#include "support/picture_blocks.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "support/mean.h"

namespace emulsion::testing {

namespace {

Difference difference_of(const Mean& mean) { return {mean.value(), mean.standard_error()}; }

double sum_of(const XYZ& pixel) {
    return static_cast<double>(pixel.x) + static_cast<double>(pixel.y) + static_cast<double>(pixel.z);
}

template <class Use>
void for_each_pixel(const PixelBounds& block, ImageView<const XYZ> a, ImageView<const XYZ> b, const Use& use) {
    for (int y = block.y0; y < block.y1; ++y) {
        for (int x = block.x0; x < block.x1; ++x) use(a(x, y), b(x, y));
    }
}

PictureDifference difference_in(const PixelBounds& block, ImageView<const XYZ> picture,
                                ImageView<const XYZ> reference) {
    Mean ref_x, ref_y, ref_sum, sum;
    for_each_pixel(block, picture, reference, [&](const XYZ& a, const XYZ& b) {
        ref_x.add(static_cast<double>(b.x));
        ref_y.add(static_cast<double>(b.y));
        ref_sum.add(sum_of(b));
        sum.add(sum_of(a));
    });
    if (!(ref_y.value() > 0.0)) throw std::invalid_argument("picture_blocks: a block of the reference is black");
    // X - x (X + Y + Z), with the reference's x, has the mean (x' - x)(X + Y + Z) for a picture of chromaticity x'.
    const double x = ref_x.value() / ref_sum.value(), y = ref_y.value() / ref_sum.value();
    Mean luminance, dx, dy;
    for_each_pixel(block, picture, reference, [&](const XYZ& a, const XYZ& b) {
        const double change_of_sum = sum_of(a) - sum_of(b);
        const double change_of_x = static_cast<double>(a.x) - static_cast<double>(b.x);
        const double change_of_y = static_cast<double>(a.y) - static_cast<double>(b.y);
        luminance.add(change_of_y / ref_y.value());
        dx.add((change_of_x - x * change_of_sum) / sum.value());
        dy.add((change_of_y - y * change_of_sum) / sum.value());
    });
    return {difference_of(luminance), difference_of(dx), difference_of(dy)};
}

void check_sizes(ImageView<const XYZ> picture, ImageView<const XYZ> reference) {
    if (picture.width() != reference.width() || picture.height() != reference.height()) {
        throw std::invalid_argument("picture_blocks: pictures of different size");
    }
}

}  // namespace

std::vector<PictureDifference> block_differences(ImageView<const XYZ> picture, ImageView<const XYZ> reference,
                                                 int size_px) {
    check_sizes(picture, reference);
    if (size_px < 2) throw std::invalid_argument("picture_blocks: size_px = " + std::to_string(size_px) + ", not >= 2");
    std::vector<PictureDifference> blocks;
    for (int y = 0; y < picture.height(); y += size_px) {
        for (int x = 0; x < picture.width(); x += size_px) {
            const PixelBounds block = {x, y, std::min(x + size_px, picture.width()),
                                       std::min(y + size_px, picture.height())};
            blocks.push_back(difference_in(block, picture, reference));
        }
    }
    return blocks;
}

PictureDifference picture_difference(ImageView<const XYZ> picture, ImageView<const XYZ> reference) {
    check_sizes(picture, reference);
    return difference_in({0, 0, picture.width(), picture.height()}, picture, reference);
}

}  // namespace emulsion::testing
