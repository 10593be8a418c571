#pragma once
// Pictures for benchmarks of tone mapping, and the memory copy that they are measured by.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>

#include <benchmark/benchmark.h>

#include "core/color.h"
#include "core/image.h"
#include "core/random.h"
#include "core/row_blocks.h"

namespace emulsion {

inline constexpr XYZ kDisplayWhite{0.95f, 1.0f, 1.09f};

/// Steps of four decades, slopes and some noise: neighbourhoods of every width.
inline Image<XYZ> make_scene(int width, int height) {
    Image<XYZ> scene(width, height);
    parallel_for_rows(width, height, 0, [&](int y) {
        Pcg32 random(static_cast<std::uint64_t>(y));
        for (int x = 0; x < width; ++x) {
            const auto step = static_cast<float>((x / 97 + y / 61) % 5 - 2);
            const float slope = std::sin(0.01f * static_cast<float>(x)) * std::cos(0.013f * static_cast<float>(y));
            const float luminance = std::pow(10.0f, step + slope + 0.1f * random.next_float());
            scene(x, y) = {0.9f * luminance, luminance, 1.1f * luminance};
        }
    });
    return scene;
}

/// Of 1, 8 or 33 megapixels; kept, as they take long to make.
inline const Image<XYZ>& scene_of(std::int64_t megapixels) {
    static std::map<std::int64_t, Image<XYZ>> pictures;
    Image<XYZ>& picture = pictures[megapixels];
    if (picture.width() == 0) {
        picture = megapixels == 1   ? make_scene(1024, 1024)
                  : megapixels == 8 ? make_scene(3840, 2160)
                                    : make_scene(7680, 4320);
    }
    return picture;
}

inline void count_pixels(benchmark::State& state, const Image<XYZ>& scene) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.pixels().size()));
}

/// Arguments: megapixels, threads.
inline void memory_copy(benchmark::State& state) {
    const Image<XYZ>& scene = scene_of(state.range(0));
    Image<XYZ> copy(scene.width(), scene.height());
    for (auto _ : state) {
        parallel_for_rows(copy.width(), copy.height(), static_cast<int>(state.range(1)), [&](int y) {
            const std::span<const XYZ> row = scene.row(y);
            std::memcpy(copy.row(y).data(), row.data(), row.size_bytes());
        });
        benchmark::ClobberMemory();
    }
    count_pixels(state, scene);
}

}  // namespace emulsion
