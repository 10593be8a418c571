// Local operators on pictures of 1, 8 and 33 megapixels beside a memory copy of the same picture, on one thread and on
// all. Each is verified against its double-precision twin on a small picture before it is timed, and so is each
// adaptation alone; ratios are for one run on one machine.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/named_value.h"
#include "core/random.h"
#include "core/row_blocks.h"
#include "tonemap/relative_luminance.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

constexpr XYZ kWhite{0.95f, 1.0f, 1.09f};

/// Steps of four decades, slopes and some noise: neighbourhoods of every width.
Image<XYZ> make_scene(int width, int height) {
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

/// By megapixels; kept, as they take long to make.
const Image<XYZ>& scene_of(std::int64_t megapixels) {
    static std::map<std::int64_t, Image<XYZ>> pictures;
    Image<XYZ>& picture = pictures[megapixels];
    if (picture.width() == 0) {
        picture = megapixels == 1   ? make_scene(1024, 1024)
                  : megapixels == 8 ? make_scene(3840, 2160)
                                    : make_scene(7680, 4320);
    }
    return picture;
}

void count_pixels(benchmark::State& state, const Image<XYZ>& scene) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.pixels().size()));
}

/// The numbers of the alternatives of a variant that `is_wanted`.
template <class Variant, class IsWanted>
std::vector<std::int64_t> numbers_of(const IsWanted& is_wanted) {
    std::vector<std::int64_t> numbers;
    std::int64_t number = 0;
    for_each_alternative<Variant>([&](const auto& alternative) {
        if (is_wanted(Variant{alternative})) numbers.push_back(number);
        ++number;
    });
    return numbers;
}

/// The alternative of a number; its name becomes the label.
template <class Variant>
Variant alternative_of(std::int64_t wanted, benchmark::State& state) {
    Variant found;
    std::int64_t number = 0;
    for_each_alternative<Variant>([&](const auto& alternative) {
        if (number++ != wanted) return;
        found = alternative;
        state.SetLabel(std::string(alternative.kName));
    });
    return found;
}

/// Empty if displayed luminances are off the twin's by less than 1 % of display white on average. Colour differences,
/// which the tolerance is stated in, are left to tests/develop.
std::string disagreement(const ToneMapping& mapping) {
    const Image<XYZ> scene = make_scene(192, 128);
    const Image<XYZ> fast = tone_map(mapping, scene.view(), kWhite, 0).image;
    const Image<XYZd> exact = tone_map_reference(mapping, scene.view(), {kWhite.x, kWhite.y, kWhite.z});
    double sum = 0.0;
    for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
        sum += std::abs(std::min(double{fast.pixels()[i].y}, 1.0) - std::min(exact.pixels()[i].y, 1.0));
    }
    const double mean = sum / static_cast<double>(fast.pixels().size());
    return mean < 0.01 ? std::string() : "off its twin by " + std::to_string(mean) + " on average";
}

void memory_copy(benchmark::State& state) {
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

void tone_map_fast(benchmark::State& state) {
    const auto mapper = alternative_of<ToneMapper>(state.range(0), state);
    if (const std::string reason = disagreement({mapper}); !reason.empty()) return state.SkipWithError(reason.c_str());
    const Image<XYZ>& scene = scene_of(state.range(1));
    Image<XYZ> display(scene.width(), scene.height());
    for (auto _ : state) {
        tone_map_into({mapper}, scene.view(), display.view(), kWhite, static_cast<int>(state.range(2)));
        benchmark::ClobberMemory();
    }
    count_pixels(state, scene);
}

/// Of a picture so small that every pixel of a bilateral window can be looked at.
void tone_map_twin(benchmark::State& state) {
    const auto mapper = alternative_of<ToneMapper>(state.range(0), state);
    const Image<XYZ> scene = make_scene(192, 128);
    for (auto _ : state) {
        benchmark::DoNotOptimize(tone_map_reference({mapper}, scene.view(), {kWhite.x, kWhite.y, kWhite.z}));
    }
    count_pixels(state, scene);
}

/// The adaptation alone, on 8 megapixels.
void adaptation(benchmark::State& state) {
    const auto chosen = alternative_of<Adaptation>(state.range(0), state);
    const Image<XYZ>& scene = scene_of(8);
    const SceneLuminance luminance = SceneLuminance(scene.view(), 0);
    for (auto _ : state) {
        benchmark::DoNotOptimize(adapt(chosen, scene.view(), luminance, static_cast<int>(state.range(1))));
    }
    count_pixels(state, scene);
}

const std::vector<std::int64_t> kSizes = {1, 8, 33};
const std::vector<std::int64_t> kOperators =
    numbers_of<ToneMapper>([](const ToneMapper& mapper) { return is_local(own_adaptation(mapper)); });
const std::vector<std::int64_t> kAdaptations =
    numbers_of<Adaptation>([](const Adaptation& chosen) { return is_local(chosen); });

BENCHMARK(memory_copy)
    ->ArgNames({"megapixels", "threads"})
    ->ArgsProduct({kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(tone_map_fast)
    ->ArgNames({"operator", "megapixels", "threads"})
    ->ArgsProduct({kOperators, kSizes, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(tone_map_twin)->ArgName("operator")->ArgsProduct({kOperators})->Unit(benchmark::kMillisecond);
BENCHMARK(adaptation)
    ->ArgNames({"adaptation", "threads"})
    ->ArgsProduct({kAdaptations, {1, 0}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
