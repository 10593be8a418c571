#include "chart/gnuplot.h"

#include <filesystem>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/text_file.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::HasSubstr, testing::Not, testing::StartsWith, testing::ThrowsMessage;

Chart example() {
    Chart chart{.name = "example", .title = "It's `a` title @b \"c\" \\", .note = "a note"};
    ChartPanel& panel = chart.panels.emplace_back();
    panel.title = "panel";
    panel.x.label = "time";
    panel.y = {.label = "error", .unit = "dE", .least_drawn = 1e-6};
    panel.points = {{.series = "one", .label = "label of one", .x = {1.0, 0.9, 1.2}, .y = exactly(2.0)},
                    {.series = "two", .label = "label of two", .x = exactly(3.0), .y = exactly(0.0)},
                    {.series = "two", .label = "worse", .x = exactly(4.0), .y = exactly(0.5)}};
    mark_front(panel);
    return chart;
}

TEST(Gnuplot, DrawsSvgAndPngByTheNamesEnding) {
    const TemporaryFolder folder;
    draw_chart(example(), folder.path() / "a.svg");
    const std::string svg = read_text_file(folder.path() / "a.svg");
    EXPECT_THAT(svg, StartsWith("<?xml"));
    for (const char* text : {"It\u2019s `a` title", "label of one", "error (dE)", "a note", "</svg>"}) {
        EXPECT_THAT(svg, HasSubstr(text));
    }
    draw_chart(example(), folder.path() / "a.PNG");
    EXPECT_THAT(read_text_file(folder.path() / "a.PNG"), StartsWith("\x89PNG\r\n"));
    // Nothing else is left in the folder.
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
    EXPECT_THROW(draw_chart(example(), folder.path() / "a.pdf"), std::invalid_argument);
}

TEST(Gnuplot, TakesTextsAsTexts) {
    const TemporaryFolder folder;
    const std::string mark = (folder.path() / "mark").string();
    Chart chart = example();
    chart.title = "'; system('touch " + mark + "'); print '`touch " + mark + "`";
    chart.panels[0].points[0].label = "a\nsystem('touch " + mark + "')\nEOD\n";
    chart.panels[0].points[0].series = "@mark `touch " + mark + "`";
    draw_chart(chart, folder.path() / "a.svg");
    EXPECT_FALSE(std::filesystem::exists(mark));
}

TEST(Gnuplot, NamesThePackageIfItIsMissing) {
    const TemporaryFolder folder;
    EXPECT_THAT(
        [&] { draw_chart(example(), folder.path() / "a.svg", "no-such-gnuplot"); },
        ThrowsMessage<std::runtime_error>("no-such-gnuplot: not found in PATH; Debian's package gnuplot-nox has it"));
    EXPECT_THAT([&] { check_gnuplot("no-such-gnuplot"); },
                ThrowsMessage<std::runtime_error>(HasSubstr("Debian's package gnuplot-nox")));
    EXPECT_NO_THROW(check_gnuplot());
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Gnuplot, ReportsThatItFailed) {
    const TemporaryFolder folder;
    EXPECT_THAT([&] { draw_chart(example(), folder.path() / "a.svg", "false"); },
                ThrowsMessage<std::runtime_error>(HasSubstr("false failed")));
    EXPECT_THAT([&] { draw_chart(example(), folder.path() / "a.svg", "true"); },
                ThrowsMessage<IoError>(HasSubstr("drew nothing")));
    // bash reads the script, and says what it thinks of it.
    EXPECT_THAT([&] { draw_chart(example(), folder.path() / "a.svg", "sh"); },
                ThrowsMessage<std::runtime_error>(HasSubstr("sh failed: ")));
    EXPECT_THROW(draw_chart(example(), folder.path() / "missing" / "a.svg"), IoError);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Gnuplot, DrawsZerosOfLogarithmicAxesAtTheEnd) {
    EXPECT_THAT(gnuplot_script(example(), ChartFormat::svg), HasSubstr("\n3 1e-06 "));
    Chart chart = example();
    chart.panels[0].y.least_drawn = 0.0;
    EXPECT_THROW((void)gnuplot_script(chart, ChartFormat::svg), std::invalid_argument);
}

TEST(Gnuplot, FillsThePointsOfTheFront) {
    const std::string script = gnuplot_script(example(), ChartFormat::svg);
    EXPECT_THAT(script, HasSubstr("$P0FRONT << EOD\n1 2 0.9 1.2 2 2\n3 1e-06"));
    EXPECT_THAT(script, HasSubstr("$P0S1N << EOD\n4 0.5"));
    EXPECT_THAT(script, Not(HasSubstr("$P0S0N")));
}

TEST(Gnuplot, DrawsARingAroundWhatLiesInTheSamePlace) {
    Chart chart = example();
    ChartPoint same = chart.panels[0].points[0];
    same.series = "three";
    chart.panels[0].points.push_back(same);
    const std::string script = gnuplot_script(chart, ChartFormat::svg);
    EXPECT_THAT(script, HasSubstr("$P0S0F << EOD\n1 2 0.9 1.2 2 2\nEOD\n"));
    EXPECT_THAT(script, HasSubstr("$P0S2R << EOD\n1 2 0.9 1.2 2 2\nEOD\n"));
    EXPECT_THAT(script, HasSubstr("$P0S2R with points pt 6"));
    EXPECT_THAT(script, Not(HasSubstr("$P0S2F")));
    // Joined points have lines to tell whose they are.
    chart.panels[0].lines = SeriesLines::joined;
    EXPECT_THAT(gnuplot_script(chart, ChartFormat::svg), Not(HasSubstr("$P0S2R")));
}

}  // namespace
}  // namespace emulsion
