#include "tonemap/spread_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/row_blocks.h"
#include "tonemap/blurred_light.h"
#include "tonemap/mirrored_border.h"
#include "tonemap/pixel_class.h"

namespace emulsion {

namespace {

bool is_bad(const XYZ& pixel) noexcept { return emulsion::is_bad(classify(pixel)); }

/// A power of two.
double scale_for(float largest) noexcept {
    constexpr double kLeast = 0x1p-80, kMost = 0x1p120;
    if (largest == 0.0f || (largest >= kLeast && largest <= kMost)) return 1.0;
    return std::ldexp(1.0, -std::ilogb(largest));
}

float narrowed(double value) noexcept {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

/// The kernel at all offsets of a picture that is mirrored at its edges and so repeats after twice its size.
Image<double> repeated_kernel(int width, int height, const std::function<double(double)>& kernel, double reach_px) {
    Image<double> repeated(2 * width, 2 * height);
    const int reach = static_cast<int>(std::ceil(reach_px));
    double sum = 0.0;
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            const double distance_px = std::hypot(x, y);
            if (distance_px > reach_px) continue;
            const double weight = kernel(distance_px);
            const auto wrapped = [](int i, int period) { return (i % period + period) % period; };
            repeated(wrapped(x, 2 * width), wrapped(y, 2 * height)) += weight;
            sum += weight;
        }
    }
    for (double& weight : repeated.pixels()) weight /= sum;
    return repeated;
}

/// What comes to the pixel at px, py, which is good.
XYZd gathered(ImageView<const XYZ> scene, const Image<double>& repeated, int px, int py) {
    XYZd sum;
    for (int y = 0; y < repeated.height(); ++y) {
        for (int x = 0; x < repeated.width(); ++x) {
            XYZ from = scene(mirrored(px + x, scene.width()), mirrored(py + y, scene.height()));
            if (is_bad(from)) from = scene(px, py);
            sum = sum + repeated(x, y) * XYZd{from.x, from.y, from.z};
        }
    }
    return sum;
}

}  // namespace

GoodLight good_light(ImageView<const XYZ> scene, int threads) {
    std::vector<float> largest(static_cast<std::size_t>(scene.height()));
    std::vector<unsigned char> has_bad(largest.size());
    parallel_for_rows(scene.width(), scene.height(), threads, [&](int y) {
        const auto at = static_cast<std::size_t>(y);
        for (const XYZ& pixel : scene.row(y)) {
            if (is_bad(pixel)) {
                has_bad[at] = 1;
            } else {
                largest[at] = std::max({largest[at], std::abs(pixel.x), pixel.y, std::abs(pixel.z)});
            }
        }
    });

    GoodLight light;
    light.scale = scale_for(*std::max_element(largest.begin(), largest.end()));
    light.has_bad = std::find(has_bad.begin(), has_bad.end(), 1) != has_bad.end();
    light.rows = {scene.width(), scene.height(), 3, [scene, scale = light.scale](int y, std::span<float> row) {
                      auto out = row.begin();
                      for (const XYZ& pixel : scene.row(y)) {
                          const double factor = is_bad(pixel) ? 0.0 : scale;
                          const XYZ from = is_bad(pixel) ? XYZ{} : pixel;
                          for (const float value : {from.x, from.y, from.z})
                              *out++ = static_cast<float>(factor * value);
                      }
                  }};
    light.good = {scene.width(), scene.height(), 1, [scene](int y, std::span<float> row) {
                      std::transform(scene.row(y).begin(), scene.row(y).end(), row.begin(),
                                     [](const XYZ& pixel) { return is_bad(pixel) ? 0.0f : 1.0f; });
                  }};
    return light;
}

Image<XYZ> spread_light(ImageView<const XYZ> scene, double weight, std::span<const GaussianLobe> lobes, int threads) {
    Image<XYZ> result(scene.width(), scene.height());  // refuses an empty picture
    const GoodLight light = good_light(scene, threads);
    Image<float> good;  // the share of each pixel's light that falls on good ones
    if (light.has_bad) {
        good = Image<float>(scene.width(), scene.height());
        scatter(lobes, light.good, threads,
                [&](int y, std::span<const float> row) { std::copy(row.begin(), row.end(), good.row(y).begin()); });
    }
    scatter(lobes, light.rows, threads, [&](int y, std::span<const float> spread) {
        for (int x = 0; x < scene.width(); ++x) {
            const XYZ pixel = scene(x, y);
            if (light.has_bad && is_bad(pixel)) {
                result(x, y) = pixel;
                continue;
            }
            const double lost = light.has_bad ? std::max(0.0, 1.0 - double{good(x, y)}) : 0.0;
            const double kept = 1.0 - weight + weight * lost, taken = weight / light.scale;
            const float* from = &spread[3 * static_cast<std::size_t>(x)];
            result(x, y) = {narrowed(kept * pixel.x + taken * from[0]), narrowed(kept * pixel.y + taken * from[1]),
                            narrowed(kept * pixel.z + taken * from[2])};
        }
    });
    return result;
}

Image<XYZd> spread_light_reference(ImageView<const XYZ> scene, double weight,
                                   const std::function<double(double)>& kernel, double reach_px) {
    Image<double> repeated;
    if (weight > 0.0) repeated = repeated_kernel(scene.width(), scene.height(), kernel, reach_px);
    Image<XYZd> result(scene.width(), scene.height());
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            const XYZ pixel = scene(x, y);
            result(x, y) = {pixel.x, pixel.y, pixel.z};
            if (weight == 0.0 || is_bad(pixel)) continue;
            result(x, y) = (1.0 - weight) * result(x, y) + weight * gathered(scene, repeated, x, y);
        }
    }
    return result;
}

}  // namespace emulsion
