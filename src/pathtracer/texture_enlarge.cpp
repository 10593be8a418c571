#include "pathtracer/texture_enlarge.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "pathtracer/texture_lookup.h"

namespace emulsion {

namespace {

constexpr int kTaps = 4;

/// What a new texel consists of: texels first, first + 1, ... of the old ones.
struct Taps {
    int first = 0;
    std::array<float, kTaps> weight{};
};

double sinc(double x) noexcept {
    const double angle = std::numbers::pi * x;
    return std::abs(angle) < 1e-6 ? 1.0 : std::sin(angle) / angle;
}

std::vector<Taps> taps_of(int old_size, int new_size) {
    constexpr double kRadius = 2.0;
    std::vector<Taps> all(static_cast<std::size_t>(new_size));
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double centre = (static_cast<double>(i) + 0.5) * old_size / new_size;
        all[i].first = static_cast<int>(std::floor(centre - kRadius + 0.5));
        std::array<double, kTaps> weight{};
        double sum = 0.0;
        for (std::size_t j = 0; j < kTaps; ++j) {
            const double distance = all[i].first + static_cast<double>(j) + 0.5 - centre;
            weight[j] = std::abs(distance) < kRadius ? sinc(distance) * sinc(distance / kRadius) : 0.0;
            sum += weight[j];
        }
        for (std::size_t j = 0; j < kTaps; ++j) all[i].weight[j] = static_cast<float>(weight[j] / sum);
    }
    return all;
}

template <class Texel>
Image<Texel> enlarged(const Image<Texel>& image, TextureWrap wrap) {
    const auto power_for = [](int side) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(side))); };
    const int width = power_for(image.width()), height = power_for(image.height());
    const std::vector<Taps> columns = taps_of(image.width(), width), rows = taps_of(image.height(), height);

    // Rows of the old picture, and of what lies beyond it, first become wide, then are mixed to those of the new one.
    // As many are kept as one new row is made of; both go down in step.
    std::array<std::vector<Texel>, kTaps> wide;
    int next_row = rows.front().first;
    const auto slot_of = [](int row) { return static_cast<std::size_t>((row % kTaps + kTaps) % kTaps); };
    const auto widen = [&](int row) {
        std::vector<Texel>& line = wide[slot_of(row)];
        line.assign(static_cast<std::size_t>(width), Texel{});
        for (std::size_t x = 0; x < line.size(); ++x) {
            for (int j = 0; j < kTaps; ++j) {
                const Texel texel = wrapped_texel(image, wrap, columns[x].first + j, row);
                line[x] = line[x] + columns[x].weight[static_cast<std::size_t>(j)] * texel;
            }
        }
    };
    Image<Texel> result(width, height, UnsetPixels{});
    for (int y = 0; y < height; ++y) {
        const Taps& row = rows[static_cast<std::size_t>(y)];
        for (; next_row < row.first + kTaps; ++next_row) widen(next_row);
        for (int x = 0; x < width; ++x) {
            Texel sum{};
            for (int j = 0; j < kTaps; ++j) {
                const Texel& texel = wide[slot_of(row.first + j)][static_cast<std::size_t>(x)];
                sum = sum + row.weight[static_cast<std::size_t>(j)] * texel;
            }
            result(x, y) = sum;
        }
    }
    return result;
}

}  // namespace

Image<RGB> enlarged_to_powers_of_two(const Image<RGB>& image, TextureWrap wrap) { return enlarged(image, wrap); }
Image<float> enlarged_to_powers_of_two(const Image<float>& image, TextureWrap wrap) { return enlarged(image, wrap); }

}  // namespace emulsion
