// Splatting with Mitchell's filter of radius 2, where a sample goes into 16 pixels: the time for each pixel touched,
// beside a plain double[4] multiply-add into the same pixels with weights that are there already (the baseline of the
// ratios: divide the times of one run). Each benchmark first verifies its sums against the plain ones.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "film/film.h"

namespace emulsion {
namespace {

constexpr int kSide_px = 16;
constexpr std::size_t kSamples = std::size_t{kSide_px} * kSide_px * 16;
constexpr int kTouched = 4;  // along each axis

struct Sample {
    float x_px, y_px;
    XYZ value;
    int first_x, first_y;  // of the pixels touched
    std::array<float, kTouched> x_weight{}, y_weight{};
};

FilmOptions splatted_options(bool light_splats) {
    return {.width_px = kSide_px + 4,
            .height_px = kSide_px + 4,
            .filter = MitchellFilter{},
            .filter_use = FilterUse::splatted,
            .light_splats = light_splats};
}

/// Within the inner 16 x 16 pixels, so that all touch 16; pixel by pixel, as a renderer makes them.
const std::vector<Sample>& samples() {
    static const std::vector<Sample> made = [] {
        std::vector<Sample> all;
        const FilterFootprint footprint(MitchellFilter{});
        Pcg32 random(1);
        for (std::size_t i = 0; i < kSamples; ++i) {
            const auto pixel = static_cast<int>(i / 16);
            const int row = pixel / kSide_px;
            Sample s{static_cast<float>(2 + pixel % kSide_px) + random.next_float(),
                     static_cast<float>(2 + row) + random.next_float(),
                     {random.next_float(), random.next_float(), random.next_float()},
                     0,
                     0,
                     {},
                     {}};
            std::array<float, kTouched> room{};
            const auto xs = footprint.weights(FilterAxis::x, s.x_px, room.data());
            std::copy_n(xs.first, kTouched, s.x_weight.begin());
            const auto ys = footprint.weights(FilterAxis::y, s.y_px, room.data());
            std::copy_n(ys.first, kTouched, s.y_weight.begin());
            s.first_x = xs.reached.begin;
            s.first_y = ys.reached.begin;
            all.push_back(s);
        }
        return all;
    }();
    return made;
}

struct alignas(32) PlainPixel {
    std::array<double, 4> sum{};
};

void add_plain(std::vector<PlainPixel>& pixels) {
    for (const Sample& s : samples()) {
        const auto x = static_cast<double>(s.value.x), y = static_cast<double>(s.value.y),
                   z = static_cast<double>(s.value.z);
        for (std::size_t j = 0; j < kTouched; ++j) {
            PlainPixel* const row = pixels.data() +
                                    static_cast<std::size_t>(s.first_y + static_cast<int>(j)) * (kSide_px + 4) +
                                    static_cast<std::size_t>(s.first_x);
            for (std::size_t i = 0; i < kTouched; ++i) {
                const auto w = static_cast<double>(s.x_weight[i] * s.y_weight[j]);
                auto& sum = row[i].sum;
                sum[0] += w * x;
                sum[1] += w * y;
                sum[2] += w * z;
                sum[3] += w;
            }
        }
        benchmark::ClobberMemory();
    }
}

void count_touched(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples * kTouched * kTouched));
}

void plain_multiply_add(benchmark::State& state) {
    std::vector<PlainPixel> pixels(std::size_t{kSide_px + 4} * (kSide_px + 4));
    for (auto _ : state) add_plain(pixels);
    count_touched(state);
}

/// To 1e-5 of the sum of magnitudes, which is at most 1.5 times the weights' sum.
template <class Sums>
bool same_sums(const BasicFilmTile<Sums>& tile) {
    std::vector<PlainPixel> plain(tile.pixels().size());
    add_plain(plain);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const WeightedSums sums = tile.pixels()[i].sums();
        const double size = 1.0 + std::abs(plain[i].sum[3]);
        if (std::abs(sums.xyz.x - plain[i].sum[0]) > 1e-5 * size) return false;
        if (std::abs(sums.weight - plain[i].sum[3]) > 1e-5 * size) return false;
    }
    return true;
}

template <class Sums>
void splat_xyz(benchmark::State& state) {
    const BasicFilm<Sums> film(splatted_options(false));
    BasicFilmTile<Sums> tile = film.make_tile({0, 0, kSide_px + 4, kSide_px + 4});
    const auto pass = [&] {
        for (const Sample& s : samples()) {
            tile.add_at(s.x_px, s.y_px, s.value);
            benchmark::ClobberMemory();
        }
    };
    pass();
    if (!same_sums(tile)) return state.SkipWithError("sums differ from the plain ones");
    for (auto _ : state) pass();
    count_touched(state);
}

/// Into sums of 96 bits, one at a time: light splats are rare.
void light_splat_xyz(benchmark::State& state) {
    const Film film(splatted_options(true));
    FilmTile tile = film.make_tile({0, 0, kSide_px + 4, kSide_px + 4});
    for (auto _ : state) {
        for (const Sample& s : samples()) tile.splat(s.x_px, s.y_px, s.value);
        benchmark::ClobberMemory();
    }
    if (tile.light_splat_count() == 0) return state.SkipWithError("nothing arrived");
    count_touched(state);
}

/// Prints mean, median and spread of nine runs.
void nine_times(benchmark::internal::Benchmark* benchmark) { benchmark->Repetitions(9)->ReportAggregatesOnly(); }

BENCHMARK(plain_multiply_add)->Apply(nine_times);
BENCHMARK(splat_xyz<ExactSums>)->Apply(nine_times);
BENCHMARK(splat_xyz<DoubleSums>)->Apply(nine_times);
BENCHMARK(light_splat_xyz)->Apply(nine_times);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
