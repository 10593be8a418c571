// Every chart, quickly: its points, and errors that do what theory says. Of times, only how they grow is tested.

#include "chart/charts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>

#include "charts_fixture.h"
#include "core/named_value.h"
#include "display/dither.h"
#include "film/exr_compression.h"
#include "film/film_sums.h"
#include "film/filter.h"
#include "spectrum/rgb_uplift.h"
#include "spectrum/transfer_function.h"
#include "spectrum/wavelength_strategy.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

TEST(WavelengthsChart, ErrorsFallWithTheNumberOfWavelengths) {
    const Chart chart = measure_chart("wavelengths", quick());
    ASSERT_EQ(chart.panels.size(), 4u);
    for (const ChartPanel& panel : chart.panels) {
        EXPECT_EQ(series_of(panel), all_names<WavelengthStrategy>());
        for (const std::string& series : series_of(panel)) {
            const std::vector<ChartPoint> points = points_of(panel, series);
            ASSERT_EQ(points.size(), 3u);
            for (std::size_t i = 1; i < points.size(); ++i) {
                EXPECT_LT(points[i].y.median, points[i - 1].y.median) << panel.title << " " << series;
            }
        }
        // Independent wavelengths: error^2 = variance / N. Each error is of 2000 squared deviates, so that of two of
        // them the logarithms differ by no more than 4 sqrt(kurtosis / 2000 / 2) = 0.15 from what they should with a
        // kurtosis of 6, which these bounded estimates don't reach.
        const std::vector<ChartPoint> independent = points_of(panel, "independent");
        EXPECT_NEAR(std::log2(independent[0].y.median / independent[2].y.median), 0.5 * 4.0, 0.3) << panel.title;
    }
}

TEST(UpliftChart, HasEveryMethodAndTellsTheExactOnesFromTheTable) {
    const Chart chart = measure_chart("uplift", quick());
    ASSERT_EQ(chart.panels.size(), 3u);
    for (const ChartPanel& panel : chart.panels) EXPECT_EQ(series_of(panel), all_names<UpliftMethod>());
    // docs/rgb-uplift.md: the solver ends at single-precision coefficients, the table is interpolated.
    const auto trip = [&](const char* method) {
        return points_of(panel_of(chart, "Round trip"), method).at(0).y.median;
    };
    EXPECT_LT(trip("sigmoid"), 1e-3);
    EXPECT_GT(trip("sigmoid-table"), 1e-3);
    EXPECT_LT(trip("sigmoid-table"), 0.1);
    // Metamers drift: no method knows the pigment.
    for (const char* title : {"Relit by A", "Relit by FL11"}) {
        for (const ChartPoint& point : panel_of(chart, title).points) {
            EXPECT_GT(point.y.median, 0.3) << point.series;
            EXPECT_LT(point.y.median, 5.0) << point.series;
        }
    }
}

TEST(FiltersChart, KnowsWhatFiltersDo) {
    const Chart chart = measure_chart("filters", quick());
    ASSERT_EQ(chart.panels.size(), 3u);
    for (const ChartPanel& panel : chart.panels) {
        ASSERT_EQ(panel.points.size(), 2 * std::variant_size_v<Filter>);
        EXPECT_EQ(series_of(panel), (std::set<std::string>{"importance-sampled", "splatted"}));
    }
    const auto error = [&](const char* title, const char* use, const char* filter) {
        for (const ChartPoint& point : panel_of(chart, title).points) {
            if (point.series == use && point.label == filter) return point.y.median;
        }
        throw std::out_of_range(filter);
    };
    for (const char* use : {"importance-sampled", "splatted"}) {
        // A box lets through sinc(f): much beyond half a cycle a pixel, where a Blackman-Harris window has next to
        // nothing; within, the box keeps more.
        EXPECT_GT(error("Zone plate: aliasing", use, "box"),
                  2.5 * error("Zone plate: aliasing", use, "blackman-harris"));
        EXPECT_LT(error("Zone plate: blur", use, "box"), 0.7 * error("Zone plate: blur", use, "blackman-harris"));
    }
    // A splatted sample serves all pixels that the filter reaches: less noise for the same samples.
    for (const char* filter : {"gaussian", "mitchell", "sinc"}) {
        EXPECT_LT(error("Slanted edge: noise", "splatted", filter),
                  0.8 * error("Slanted edge: noise", "importance-sampled", filter));
    }
    // RMS of coverage with 4x4 jittered strata: 4 strata in 16 are cut by an edge that runs through a pixel, with a
    // variance of at most 1/4 in 16^2 each; so at most sqrt(7 / 4) / 16 = 0.083 with the 7 that the longest edge cuts.
    EXPECT_LT(error("Slanted edge: noise", "importance-sampled", "box"), 0.083);
    EXPECT_GT(error("Slanted edge: noise", "importance-sampled", "box"), 0.02);
}

TEST(AccumulationChart, FloatsStagnateAndExactSumsDoNot) {
    const Chart chart = measure_chart("accumulation", quick());
    const ChartPanel& panel = panel_of(chart, "Error by samples");
    EXPECT_EQ(series_of(panel), all_names<FilmSums>());
    for (const ChartPoint& point : points_of(panel, "exact")) {
        // Each sample is off by at most 2^-45, of a mean of 1/2; the sum is then rounded to double.
        EXPECT_LE(point.y.median, 2.0 * 0x1p-45) << point.x.median;
    }
    for (const ChartPoint& point : points_of(panel, "double")) {
        EXPECT_LE(point.y.median, 0.5 * point.x.median * 0x1p-53) << point.x.median;
    }
    for (const ChartPoint& point : points_of(panel, "kahan-float")) {
        // Kahan's bound is 2 epsilon, of float.
        EXPECT_LE(point.y.median, 2.0 * 0x1p-24) << point.x.median;
    }
    // 3e7 samples of 1/2 add up to 1.6e7: past 2^23 samples below 1/2 of the last place are lost, those above count 1.
    EXPECT_GT(points_of(panel, "float").back().y.median, 1e-3);
    EXPECT_EQ(chart.panels[1].points.size(), std::variant_size_v<FilmSums>);
}

TEST(TonemapChart, HasEveryOperatorWithinItsTolerance) {
    const Chart chart = measure_chart("tonemap", quick());
    ASSERT_EQ(chart.panels[0].points.size(), std::variant_size_v<ToneMapper>);
    for (const ChartPoint& point : chart.panels[0].points) {
        // What tone_map_reference() states.
        EXPECT_LE(point.y.median, point.series == "global" ? 0.001 : 0.1) << point.label;
        EXPECT_GE(detail(point, "max"), point.y.median) << point.label;
        EXPECT_GT(detail(point, "Mpix/s"), 0.0) << point.label;
    }
}

TEST(TransferChart, HasEveryFunctionWithinItsTolerance) {
    const Chart chart = measure_chart("transfer", quick());
    ASSERT_EQ(chart.panels[0].points.size(), 2 * std::variant_size_v<TransferFunction>);
    for (const ChartPoint& point : chart.panels[0].points) {
        // 6.4e-8 of TransferEncoder; half a unit in the last place of a float below 1 of the definition.
        EXPECT_LE(point.y.median, point.series == "definition" ? 65535.0 * 0x1p-25 : 0.0042) << point.label;
    }
}

TEST(DitherChart, HasEveryDitherAndSeesTheBestOnes) {
    const Chart chart = measure_chart("dither", quick());
    ASSERT_EQ(chart.panels.size(), 2u);
    for (const ChartPanel& panel : chart.panels) {
        ASSERT_EQ(series_of(panel), all_names<Dither>());
        const auto error = [&](const char* dither) { return points_of(panel, dither).at(0).y.median; };
        // White noise has its error at all frequencies, the others most of it where the eye sees little.
        for (const char* dither : {"blue-noise", "bayer", "floyd-steinberg", "jarvis", "stucki"}) {
            EXPECT_LT(error(dither), error("white-noise")) << panel.title << " " << dither;
        }
    }
    // Fifteen times as fine steps: a fifteenth of the error.
    for (const char* dither : {"white-noise", "blue-noise", "floyd-steinberg"}) {
        const double ratio =
            points_of(chart.panels[0], dither).at(0).y.median / points_of(chart.panels[1], dither).at(0).y.median;
        EXPECT_NEAR(std::log(ratio / 15.0), 0.0, std::log(1.6)) << dither;
    }
}

TEST(ExrChart, LosesWhatCompressionsSayTheyLose) {
    const Chart chart = measure_chart("exr", quick());
    const std::size_t count = std::variant_size_v<ExrCompression>;
    ASSERT_EQ(chart.panels.size(), 3u);
    for (const ChartPanel& panel : chart.panels) ASSERT_EQ(panel.points.size(), 2 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const ChartPoint &size = chart.panels[0].points[i], &loss = chart.panels[1].points[i];
        const ExrCompression compression = parse_named<ExrCompression>(loss.label, "compression");
        // RGB and back to XYZ in floats: rounding of 2^-24, far below 1e-4 of CIEDE2000.
        if (!is_lossy(compression)) {
            EXPECT_LT(loss.y.median, 1e-4) << loss.label;
        }
        if (loss.label == "dwaa" || loss.label == "pxr24") {
            EXPECT_GT(loss.y.median, 1e-5) << loss.label;
        }
        if (loss.label == "none") {
            EXPECT_NEAR(size.y.median, 12.0, 0.5);
            EXPECT_NEAR(chart.panels[0].points[i + count].y.median, 6.0, 0.5);
        }
        // Of halves there is half as much, and 11 bits.
        EXPECT_LT(chart.panels[1].points[i + count].y.median, 1.0) << loss.label;
    }
}

bool grows_linearly(const ChartPanel& panel) { return std::abs(fitted_exponent(panel, "time") - 1.0) <= 0.1; }

/// The exponent of Monte Carlo, those of what is counted, and those of times. Other programs on the machine change
/// times, if little, as they are processor time: one measurement in three has to be undisturbed.
TEST(ScalingChart, ErrorsFallWithTheRootOfSamplesAndTimeAndMemoryGrowWithPixels) {
    Chart chart = measure_chart("scaling", quick());
    ASSERT_EQ(chart.panels.size(), 5u);
    for (int again = 0; again < 2 && !(grows_linearly(chart.panels[0]) && grows_linearly(chart.panels[1])); ++again) {
        chart = measure_chart("scaling", quick());
    }
    const auto panel = [&](const std::string& start) -> const ChartPanel& {
        for (const ChartPanel& one : chart.panels) {
            if (one.title.starts_with(start)) return one;
        }
        throw std::out_of_range(start);
    };
    // Each point is the median of 5 RMS errors over 9216 pixels with independent noise. With a kurtosis of the pixels'
    // errors below 100, the relative standard error of one RMS is sqrt(100 / 9216) / 2 = 0.05, of the medians 0.03; the
    // slope through ln 1, ln 4, ln 16 has then 0.03 sqrt(2) / ln 16 = 0.015. The reference's own noise, 1/1024 of that
    // of one sample, makes it shallower by ln(1 + 16/1024) / 2 / ln 16 = 0.003.
    EXPECT_NEAR(fitted_exponent(panel("Error by samples"), "error"), -0.5, 4.0 * 0.015 + 0.003);
    EXPECT_NEAR(fitted_exponent(panel("Pixels"), "time"), 1.0, 0.1);
    EXPECT_NEAR(fitted_exponent(panel("Samples"), "time"), 1.0, 0.1);
    // The film's fixed part is less than 1 % of the smallest.
    EXPECT_NEAR(fitted_exponent(panel("Pixels"), "memory"), 1.0, 0.1);
    for (const ChartPoint& point : panel("Pixels").points) EXPECT_GT(point.y.median, 0.0);
    EXPECT_EQ(points_of(panel("Triangles"), "memory").size(), 3u);
}

TEST(Charts, RefuseWhatTheyDoNotKnow) {
    EXPECT_THAT([] { (void)measure_chart("wavelenghts", quick()); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("wavelengths")));
    EXPECT_THAT([] { (void)measure_chart("models", quick()); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("at least one scene")));
}

/// The chart as it is drawn.
class Exponents : public testing::TestWithParam<int> {};

TEST_P(Exponents, AreWhatTheoryAsksFor) {
    const Chart chart = measure_chart("scaling", {.effort = ChartEffort::full, .threads = 1});
    EXPECT_NEAR(fitted_exponent(chart.panels[0], "time"), 1.0, 0.1);
    EXPECT_NEAR(fitted_exponent(chart.panels[1], "time"), 1.0, 0.1);
    EXPECT_NEAR(fitted_exponent(chart.panels[2], "error"), -0.5, 0.05);
    EXPECT_NEAR(fitted_exponent(chart.panels[3], "memory"), 1.0, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Long, Exponents, testing::Values(0));

}  // namespace
}  // namespace emulsion
