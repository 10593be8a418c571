// Ways of summing the samples of a pixel: time of an addition, and error of the sum, by the number of samples.

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

/// Random samples of the luminance weight * y, y in [0.03, 1.03) and weight in [0.5, 1.5): all multiples of 2^-53.
struct Sample {
    double y, weight;
};

class Samples {
  public:
    Sample next() noexcept {
        const float y = 0.03f + random_.next_float(), weight = 0.5f + random_.next_float();
        return {static_cast<double>(y), static_cast<double>(weight)};
    }

  private:
    Pcg32 random_{11};
};

/// The exact sum, as an integer: products of two floats are exact in double precision.
class IntegerSum {
  public:
    void add(const Sample& sample) noexcept {
        units_ += static_cast<Int128>(static_cast<std::int64_t>(sample.y * sample.weight * kUnitsPerOne));
    }
    [[nodiscard]] double value() const noexcept { return static_cast<double>(units_) / kUnitsPerOne; }

  private:
    static constexpr double kUnitsPerOne = 0x1p56;
    Int128 units_ = 0;
};

/// The pixel goes through memory at each sample, as in a renderer.
template <class Pixel>
void add(Pixel& pixel, const Sample& sample) {
    pixel.add(0.9 * sample.y, sample.y, 1.1 * sample.y, sample.weight);
    keep(pixel);
}

constexpr std::size_t kSamplesOfWork = 4096;

template <class Pixel>
Work timed_additions() {
    std::vector<Sample> samples(kSamplesOfWork);
    Samples source;
    for (Sample& sample : samples) sample = source.next();
    return [samples, pixel = Pixel()]() mutable {
        pixel = {};
        for (const Sample& sample : samples) add(pixel, sample);
    };
}

template <class Sums>
void measure(const std::vector<std::int64_t>& counts, Chart& chart, std::vector<Work>& works) {
    using Pixel = typename Sums::TilePixel;
    Pixel pixel;
    IntegerSum exact;
    Samples source;
    const std::string name(Sums::kName);
    std::int64_t done = 0;
    double error = 0.0;
    for (const std::int64_t count : counts) {
        for (; done < count; ++done) {
            const Sample sample = source.next();
            add(pixel, sample);
            exact.add(sample);
            if constexpr (std::is_same_v<Pixel, ExactTilePixel>) {
                if ((done + 1) % ExactTilePixel::kAddsPerCarry == 0) pixel.carry();
            }
        }
        error = std::abs(pixel.sums().xyz.y - exact.value()) / exact.value();
        chart.panels[0].points.push_back(
            {.series = name, .label = "", .x = exactly(static_cast<double>(count)), .y = exactly(error)});
    }
    chart.panels[1].points.push_back({.series = name, .label = name, .y = exactly(error)});
    works.push_back(timed_additions<Pixel>());
}

}  // namespace

Chart measure_accumulation_chart(const ChartOptions& options) {
    std::vector<std::int64_t> counts;
    const std::int64_t most = options.effort == ChartEffort::quick ? 30'000'000 : 1'000'000'000;
    for (std::int64_t count = 1000; count < most; count *= 10) counts.push_back(count);
    counts.push_back(most);
    Chart chart{.name = "accumulation",
                .title = "Ways of summing the samples of a pixel",
                .note =
                    "Random samples, added one by one: X, Y, Z and the weight. Error: of the sum of Y against that "
                    "of the same numbers as integers of 128 bits, which is exact; errors below 1e-17 are drawn "
                    "there. Exact sums round each sample once, to 2^-44 cd/m^2."};
    const ChartAxis error = {.label = "relative error", .least_drawn = 1e-17};
    chart.panels = {{.title = "Error by samples", .x = {.label = "samples"}, .y = error, .lines = SeriesLines::joined},
                    {.title = fmt::format("{:.0e} samples", static_cast<double>(most)),
                     .x = {.label = "time of an addition / of double"},
                     .y = error}};
    std::vector<Work> works;
    for_each_alternative<FilmSums>([&]<class Sums>(const Sums&) { measure<Sums>(counts, chart, works); });
    set_times(chart.panels[1],
              times_relative_to(timed_additions<DoubleSums::TilePixel>(), works, timing_options(options)),
              {.name = "ns", .factor = 1e9 / kSamplesOfWork});
    return chart;
}

}  // namespace emulsion
