#include "chart/chart.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "chart/chart_csv.h"
#include "core/error.h"

namespace emulsion {
namespace {

using testing::HasSubstr, testing::ElementsAre, testing::DoubleNear, testing::ThrowsMessage;

ChartPoint point(const std::string& series, double x, double y) {
    return {.series = series, .label = "", .x = exactly(x), .y = exactly(y)};
}

std::string front_of(const ChartPanel& panel) {
    std::string names;
    for (const ChartPoint& p : panel.points) names += p.on_front ? p.series : "";
    return names;
}

TEST(Spread, IsTheMedianAndTheQuartilesBetweenValues) {
    EXPECT_EQ(spread_of({5.0, 1.0, 3.0, 2.0, 4.0}), (Spread{3.0, 2.0, 4.0}));
    EXPECT_EQ(spread_of({1.0, 2.0}), (Spread{1.5, 1.25, 1.75}));
    EXPECT_THROW((void)spread_of({}), std::invalid_argument);
}

TEST(Front, HoldsWhatNothingBeats) {
    ChartPanel panel;
    // b is beaten by a on y alone, d by c on both; e and f share a place.
    panel.points = {point("a", 1, 5), point("b", 1, 6), point("c", 2, 3), point("d", 3, 4),
                    point("e", 4, 1), point("f", 4, 1), point("g", 5, 1)};
    mark_front(panel);
    EXPECT_EQ(front_of(panel), "acef");
}

TEST(Front, KnowsWhichEndIsBetter) {
    ChartPanel panel;
    panel.x.better = BetterEnd::high;
    panel.points = {point("a", 1, 1), point("b", 2, 2), point("c", 1.5, 3), point("d", 3, 2)};
    mark_front(panel);
    EXPECT_EQ(front_of(panel), "ad");
    // Where more or less of x is no better, only y counts.
    panel.x.better = BetterEnd::neither;
    mark_front(panel);
    EXPECT_EQ(front_of(panel), "a");
}

/// Of (i, sqrt(R^2 - i^2)) on a quarter of a circle with the better corner outside nothing beats anything; a point
/// inside by any amount is beaten if a point of the circle lies between it and the corner.
TEST(Front, OfAHyperbolaIsAllOfIt) {
    ChartPanel panel;
    for (int i = 1; i <= 20; ++i) {
        panel.points.push_back(point("h", i, 1.0 / i));
        panel.points.push_back(point("x", i, 1.0001 / i));
    }
    mark_front(panel);
    for (const ChartPoint& p : panel.points) EXPECT_EQ(p.on_front, p.series == "h");
}

TEST(Exponent, IsExactForPowers) {
    for (const double exponent : {-2.0, -0.5, 0.0, 1.0, 1.7}) {
        std::vector<double> x, y;
        for (const double value : {1e-3, 0.5, 7.0, 1e6}) {
            x.push_back(value);
            y.push_back(3.0 * std::pow(value, exponent));
        }
        EXPECT_NEAR(fitted_exponent(x, y), exponent, 1e-13);
    }
}

TEST(Exponent, IsTheLeastSquaresOne) {
    // ln y = 0, 0, 3 at ln x = 0, 1, 2: the slope is cov / var = 3 / 2.
    const std::vector<double> x = {1.0, std::exp(1.0), std::exp(2.0)}, y = {1.0, 1.0, std::exp(3.0)};
    EXPECT_NEAR(fitted_exponent(x, y), 1.5, 1e-14);
}

TEST(Exponent, RefusesWhatHasNone) {
    const std::vector<double> one = {1.0}, two = {1.0, 2.0}, zero = {1.0, 0.0}, same = {2.0, 2.0};
    EXPECT_THROW((void)fitted_exponent(one, one), std::invalid_argument);
    EXPECT_THROW((void)fitted_exponent(two, one), std::invalid_argument);
    EXPECT_THROW((void)fitted_exponent(zero, two), std::invalid_argument);
    EXPECT_THROW((void)fitted_exponent(same, two), std::invalid_argument);
}

Chart example() {
    Chart chart{.name = "example", .title = "A \"title\", with a comma", .note = "two\nlines"};
    chart.panels.push_back({.title = "one",
                            .x = {.label = "time, relative", .unit = ""},
                            .y = {.label = "error",
                                  .unit = "dB",
                                  .scale = AxisScale::linear,
                                  .better = BetterEnd::high,
                                  .least_drawn = 1e-18},
                            .lines = SeriesLines::joined});
    chart.panels.push_back({.title = "two", .x = {.better = BetterEnd::neither}});
    chart.panels[0].points = {{.series = "#s", .label = "a,b", .x = {0.1, 1.0 / 3.0, 5e-324}, .y = exactly(0.0)},
                              {.series = "t",
                               .label = "",
                               .x = exactly(1e300),
                               .y = exactly(2.0),
                               .on_front = true,
                               .details = {{"Mpix/s", 0.1}, {"a=b", -1e-7}}}};
    chart.panels[1].points = {point("u", 1.0, 2.0)};
    return chart;
}

TEST(ChartCsv, ReadsBackAsTheSame) { EXPECT_EQ(parse_chart_csv(to_csv(example()), "x.csv"), example()); }

TEST(ChartCsv, TakesLineBreaksOfEitherKind) {
    Chart chart = example();
    chart.note = "one line";
    std::string text = to_csv(chart), other;
    for (const char c : text) other += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(parse_chart_csv(other, "x.csv"), chart);
}

TEST(ChartCsv, SaysWhatIsWrongAndWhere) {
    const std::string good = to_csv(example());
    const auto broken = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return [text] { (void)parse_chart_csv(text, "x.csv"); };
    };
    EXPECT_THAT(broken("# chart", "# Chart"), ThrowsMessage<IoError>(HasSubstr("x.csv: line 1")));
    EXPECT_THAT(broken("linear", "cubic"),
                ThrowsMessage<IoError>(HasSubstr("found \"cubic\", expected linear or log")));
    EXPECT_THAT(broken("1e+300", "1e+3x"), ThrowsMessage<IoError>(HasSubstr("found \"1e+3x\", expected a number")));
    EXPECT_THAT(broken("\ntwo,u", "\nthree,u"), ThrowsMessage<IoError>(HasSubstr("there is no panel \"three\"")));
    EXPECT_THAT(broken("panel,series", "panel,serie"),
                ThrowsMessage<IoError>(HasSubstr("expected panel,series,label")));
    EXPECT_THAT([] { (void)parse_chart_csv("", "x.csv"); }, ThrowsMessage<IoError>(HasSubstr("line 1")));
}

TEST(Chart, RefusesWhatCannotBeDrawn) {
    EXPECT_NO_THROW(validate(example()));
    Chart chart = example();
    chart.panels[1].points[0].y = exactly(0.0);
    EXPECT_THAT([&] { validate(chart); }, ThrowsMessage<std::invalid_argument>(HasSubstr("not above 0")));
    chart.panels[1].points[0].y = exactly(std::numeric_limits<double>::quiet_NaN());
    EXPECT_THAT([&] { validate(chart); }, ThrowsMessage<std::invalid_argument>(HasSubstr("not finite")));
    chart = example();
    chart.panels[1].title = "one";
    EXPECT_THAT([&] { validate(chart); }, ThrowsMessage<std::invalid_argument>(HasSubstr("the title \"one\"")));
    chart = example();
    chart.panels[1].points.clear();
    EXPECT_THAT([&] { validate(chart); }, ThrowsMessage<std::invalid_argument>(HasSubstr("\"two\" has no points")));
}

}  // namespace
}  // namespace emulsion
