// Tone mapping of 1 megapixel beside a memory copy of the same picture, on one thread and on all: the operators that
// adapt to the picture as a whole (local.cpp has the others). Each is verified against its double-precision twin before
// it is timed; ratios are for one run on one machine.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/named_value.h"
#include "core/random.h"
#include "core/row_blocks.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

constexpr XYZ kWhite{0.95f, 1.0f, 1.09f};

/// 1024 x 1024 pixels over six decades of luminance.
const Image<XYZ>& scene() {
    static const Image<XYZ> picture = [] {
        Pcg32 random(1);
        Image<XYZ> image(1024, 1024);
        for (XYZ& p : image.pixels()) {
            const float luminance = std::pow(10.0f, 6.0f * random.next_float() - 3.0f);
            p = {luminance * 2.0f * random.next_float(), luminance, luminance * 2.0f * random.next_float()};
        }
        return image;
    }();
    return picture;
}

void count_pixels(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene().pixels().size()));
}

/// The numbers of these operators in the variant.
const std::vector<std::int64_t> kOperators = [] {
    std::vector<std::int64_t> numbers;
    std::int64_t number = 0;
    for_each_alternative<ToneMapper>([&](const auto& mapper) {
        if (!is_local(own_adaptation(mapper))) numbers.push_back(number);
        ++number;
    });
    return numbers;
}();

/// The operator whose number is the benchmark's first argument; its name becomes the label.
ToneMapper alternative_of_range(benchmark::State& state) {
    ToneMapper found;
    std::int64_t number = 0;
    for_each_alternative<ToneMapper>([&](const auto& mapper) {
        if (number++ != state.range(0)) return;
        found = mapper;
        state.SetLabel(std::string(mapper.kName));
    });
    return found;
}

/// Empty if the fast path keeps to its tolerance.
std::string disagreement(const ToneMapper& mapper) {
    const Image<XYZ> fast = tone_map({mapper}, scene().view(), kWhite, 0).image;
    const Image<XYZd> exact = tone_map_reference({mapper}, scene().view(), {kWhite.x, kWhite.y, kWhite.z});
    for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
        const double difference = std::abs(fast.pixels()[i].y - exact.pixels()[i].y);
        if (!(difference <= 2e-4 * exact.pixels()[i].y)) return "pixel " + std::to_string(i) + " is off its twin";
    }
    return {};
}

void memory_copy(benchmark::State& state) {
    Image<XYZ> copy(scene().width(), scene().height());
    for (auto _ : state) {
        parallel_for_rows(copy.width(), copy.height(), static_cast<int>(state.range(0)), [&](int y) {
            const std::span<const XYZ> row = scene().row(y);
            std::memcpy(copy.row(y).data(), row.data(), row.size_bytes());
        });
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

void statistics(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(luminance_statistics(scene().view(), static_cast<int>(state.range(0))));
    }
    count_pixels(state);
}

void statistics_twin(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(luminance_statistics_reference(scene().view()));
    count_pixels(state);
}

void tone_map_fast(benchmark::State& state) {
    const auto mapper = alternative_of_range(state);
    if (const std::string reason = disagreement(mapper); !reason.empty()) return state.SkipWithError(reason.c_str());
    Image<XYZ> display(scene().width(), scene().height());
    for (auto _ : state) {
        tone_map_into({mapper}, scene().view(), display.view(), kWhite, static_cast<int>(state.range(1)));
        benchmark::ClobberMemory();
    }
    count_pixels(state);
}

void tone_map_twin(benchmark::State& state) {
    const auto mapper = alternative_of_range(state);
    for (auto _ : state) {
        benchmark::DoNotOptimize(tone_map_reference({mapper}, scene().view(), {kWhite.x, kWhite.y, kWhite.z}));
    }
    count_pixels(state);
}

BENCHMARK(memory_copy)->ArgName("threads")->Arg(1)->Arg(0)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(statistics)->ArgName("threads")->Arg(1)->Arg(0)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(statistics_twin)->Unit(benchmark::kMicrosecond);
BENCHMARK(tone_map_fast)
    ->ArgNames({"operator", "threads"})
    ->ArgsProduct({kOperators, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(tone_map_twin)->ArgName("operator")->ArgsProduct({kOperators})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
