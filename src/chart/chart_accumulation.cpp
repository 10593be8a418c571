// Ways of summing the samples of a pixel: time of an addition, and error of the sum, by the number of samples.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "chart/charts.h"
#include "chart/measure.h"
#include "core/named_value.h"
#include "core/random.h"
#include "film/film_sums.h"

namespace emulsion {

namespace {

/// Samples that are gone round and round, so that their exact sum is known: luminances of one decade and a half.
constexpr std::size_t kCycle = 4096;
constexpr int kFractionBits = 56;

struct Cycle {
    std::array<float, kCycle> luminance{};
    std::array<Int128, kCycle + 1> sum_before{};  // in units of 2^-kFractionBits: every luminance is a whole number
};

Cycle make_cycle() {
    Cycle cycle;
    Pcg32 random(11);
    for (std::size_t i = 0; i < kCycle; ++i) {
        cycle.luminance[i] = 0.03f + random.next_float();
        const double units = std::ldexp(static_cast<double>(cycle.luminance[i]), kFractionBits);
        cycle.sum_before[i + 1] = cycle.sum_before[i] + static_cast<Int128>(units);
    }
    return cycle;
}

double exact_sum(const Cycle& cycle, std::int64_t samples) {
    const Int128 units = cycle.sum_before[kCycle] * (samples / static_cast<std::int64_t>(kCycle)) +
                         cycle.sum_before[static_cast<std::size_t>(samples) % kCycle];
    return std::ldexp(static_cast<double>(units), -kFractionBits);
}

/// Adds samples [from, to) of the cycle. The pixel goes through memory at each, as in a renderer.
template <class Pixel>
void add(Pixel& pixel, const Cycle& cycle, std::int64_t from, std::int64_t to) {
    for (std::int64_t i = from; i < to; ++i) {
        const auto y = static_cast<double>(cycle.luminance[static_cast<std::size_t>(i) % kCycle]);
        pixel.add(0.9 * y, y, 1.1 * y, 1.0);
        keep(pixel);
        if constexpr (std::is_same_v<Pixel, ExactTilePixel>) {
            if ((i + 1) % (std::int64_t{1} << 23) == 0) pixel.carry();
        }
    }
}

template <class Sums>
void measure(const Cycle& cycle, const std::vector<std::int64_t>& counts, Chart& chart, std::vector<Work>& works) {
    typename Sums::TilePixel pixel;
    const std::string name(Sums::kName);
    std::int64_t done = 0;
    double error = 0.0;
    for (const std::int64_t count : counts) {
        add(pixel, cycle, done, count);
        done = count;
        const double exact = exact_sum(cycle, count);
        error = std::abs(pixel.sums().xyz.y - exact) / exact;
        chart.panels[0].points.push_back(
            {.series = name, .label = "", .x = exactly(static_cast<double>(count)), .y = exactly(error)});
    }
    chart.panels[1].points.push_back({.series = name, .label = name, .y = exactly(error)});
    works.push_back([cycle, cleared = typename Sums::TilePixel()]() mutable {
        cleared = {};
        add(cleared, cycle, 0, kCycle);
    });
}

}  // namespace

Chart measure_accumulation_chart(const ChartOptions& options) {
    std::vector<std::int64_t> counts;
    const std::int64_t most = options.effort == ChartEffort::quick ? 100'000'000 : 1'000'000'000;
    for (std::int64_t count = 1000; count <= most; count *= 10) counts.push_back(count);
    const Cycle cycle = make_cycle();
    Chart chart{.name = "accumulation",
                .title = "Ways of summing the samples of a pixel",
                .note =
                    "Every sample is added one by one; X, Y, Z and the weight. Error: of the sum of Y against that "
                    "of the same numbers as integers of 128 bits, which is exact; errors below 1e-17 are drawn "
                    "there. Exact sums round each sample once, to 2^-44 cd/m^2."};
    const ChartAxis error = {.label = "relative error", .least_drawn = 1e-17};
    chart.panels = {{.title = "Error by samples", .x = {.label = "samples"}, .y = error, .lines = SeriesLines::joined},
                    {.title = fmt::format("{:.0e} samples", static_cast<double>(most)),
                     .x = {.label = "time of an addition / of double"},
                     .y = error}};
    std::vector<Work> works;
    for_each_alternative<FilmSums>([&]<class Sums>(const Sums&) { measure<Sums>(cycle, counts, chart, works); });
    const Work baseline = [cycle, cleared = DoubleSums::TilePixel()]() mutable {
        cleared = {};
        add(cleared, cycle, 0, kCycle);
    };
    set_times(chart.panels[1], times_relative_to(baseline, works, timing_options(options)),
              {.name = "ns", .factor = 1e9 / kCycle});
    return chart;
}

}  // namespace emulsion
