#include "display/diffuse_rows.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include "dither_fixture.h"

namespace emulsion {
namespace {

/// Calls visitor.operator()<kernel>() for all kernels.
template <class Visitor>
void for_each_kernel(const Visitor& visitor) {
    visitor.template operator()<kFloydSteinbergKernel>();
    visitor.template operator()<kJarvisKernel>();
    visitor.template operator()<kStuckiKernel>();
    visitor.template operator()<kSierraKernel>();
    visitor.template operator()<kAtkinsonKernel>();
}

Image<CodeRGB> plain_codes(const DiffusionKernel& kernel, RowOrder order, const Image<RGB>& picture,
                           const CodeScale& scale) {
    Image<CodeRGB> codes(picture.width(), picture.height());
    diffuse_plainly(kernel, order, rgb_rows(picture.view()), scale, rgb_rows(codes.view()));
    return codes;
}

/// Random, with parts that are black and white or that leave a little to be carried on.
Image<RGB> hard_picture(int width, int height) {
    Image<RGB> picture = random_picture(width, height, 57);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (y > height / 2) picture(x, y).r = x < width / 2 ? 1.0f : 0.0f;
            if (y < 3) picture(x, y).g = 0.4999f;
            if (y > 3) picture(x, y).g = x % 7 == 0 ? 0.999f : 1.0f;
            if (x < 5 || x > width - 4) picture(x, y).b = 0.0f;
        }
    }
    return picture;
}

TEST(DiffuseRows, CodesAreThoseOfThePlainOne) {
    for (const auto& [width, height] :
         {std::pair{1, 9}, {7, 9}, {8, 1}, {8, 2}, {8, 3}, {9, 4}, {13, 40}, {64, 64}, {65, 31}, {66, 30}, {333, 77}}) {
        const Image<RGB> picture = hard_picture(width, height);
        for_each_kernel([&]<const DiffusionKernel & Kernel>() {
            for (const RowOrder order : {RowOrder::raster, RowOrder::serpentine}) {
                for (const CodeScale& scale : every_scale()) {
                    const Image<CodeRGB> plain = plain_codes(Kernel, order, picture, scale);
                    for (const int threads : {1, 2, 3, 8}) {
                        Image<CodeRGB> codes(width, height);
                        diffuse_rows<Kernel>(order, rgb_rows(picture.view()), scale, rgb_rows(codes.view()), threads);
                        ASSERT_EQ(codes, plain) << width << "x" << height << ", divisor " << Kernel.divisor
                                                << ", white " << scale.white << ", threads " << threads;
                    }
                }
            }
        });
    }
}

}  // namespace
}  // namespace emulsion
