// `emulsion chart`: measured points as CSV, drawn as SVG or PNG.

#include <cstdlib>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ChartProgram : public ::testing::Test {
  protected:
    static ProgramResult chart(std::vector<std::string> arguments, const RunOptions& options = {}) {
        arguments.insert(arguments.begin(), "chart");
        return run_program(arguments, options);
    }

    TemporaryFolder folder_;
};

TEST_F(ChartProgram, PrintsPointsWithoutAnOutput) {
    const ProgramResult result = chart({"transfer", "--quick"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, StartsWith("# chart,transfer,"));
    EXPECT_THAT(result.out, HasSubstr("\npanel,series,label,x,x_p25,x_p75,y,y_p25,y_p75,front,details\n"));
}

TEST_F(ChartProgram, WritesCsvAndDrawsAndDrawsAgain) {
    const std::string csv = folder_.file("t.csv"), svg = folder_.file("t.svg"), png = folder_.file("t.png");
    const ProgramResult measured = chart({"Transfer", "--quick", "--csv", csv, "-o", svg});
    EXPECT_EQ(measured.exit_code, 0) << measured.err;
    EXPECT_EQ(measured.out, "");
    EXPECT_THAT(read_text(csv), StartsWith("# chart,transfer,"));
    EXPECT_THAT(read_text(svg), HasSubstr("</svg>"));
    const ProgramResult drawn = chart({"--from", csv, "-o", png});
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_THAT(read_text(png), StartsWith("\x89PNG"));
    // The same points make the same drawing.
    EXPECT_EQ(chart({"--from", csv, "-o", folder_.file("again.svg")}).exit_code, 0);
    EXPECT_EQ(read_text(folder_.file("again.svg")), read_text(svg));
    EXPECT_THAT(folder_.names(), ElementsAre("again.svg", "t.csv", "t.png", "t.svg"));
}

TEST_F(ChartProgram, SaysWhereGnuplotIsToBeHad) {
    const std::string svg = folder_.file("t.svg"), csv = folder_.file("t.csv");
    const ProgramResult result =
        chart({"transfer", "--quick", "-o", svg, "--csv", csv}, {.before = [] { ::setenv("PATH", "/nowhere", 1); }});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("gnuplot: not found in PATH; Debian's package gnuplot-nox has it"));
    // At once: nothing was measured for it.
    EXPECT_THAT(folder_.names(), ElementsAre());
}

TEST_F(ChartProgram, RefusesBadUsage) {
    const std::string csv = folder_.file("t.csv"), svg = folder_.file("t.svg");
    const auto refused = [](std::vector<std::string> arguments, const std::string& message) {
        const ProgramResult result = chart(std::move(arguments));
        EXPECT_EQ(result.exit_code, 2) << message;
        EXPECT_THAT(result.err, HasSubstr(message));
    };
    refused({}, "NAME: missing, expected one of models, wavelengths");
    refused({"wavelenghts"}, "found \"wavelenghts\", expected one of models, wavelengths");
    refused({"transfer", "-o", "t.pdf"}, "expected a name ending in .svg or .png");
    refused({"models"}, "--scene: missing, and the chart \"models\" is of scenes");
    refused({"transfer", "--scene", "a.pbrt"}, "--scene: the chart \"transfer\" is not of scenes");
    refused({"models", "--scene", "a.pbrt", "--scene", "a.pbrt"}, "--scene: a.pbrt is given twice");
    refused({"--from", csv}, "--from: needs -o");
    refused({"transfer", "--from", csv, "-o", svg}, "NAME: is of a chart to measure");
    refused({"transfer", "--csv", svg, "-o", svg}, svg);
}

TEST_F(ChartProgram, ReportsFilesThatItCannotUse) {
    const std::string csv = folder_.file("t.csv");
    write_text(csv, "# chart,a,b,c\nnonsense\n");
    const ProgramResult damaged = chart({"--from", csv, "-o", folder_.file("t.svg")});
    EXPECT_EQ(damaged.exit_code, 1);
    EXPECT_THAT(damaged.err, HasSubstr("t.csv: line 2: expected panel,series,label"));
    EXPECT_EQ(chart({"--from", folder_.file("none.csv"), "-o", folder_.file("t.svg")}).exit_code, 1);
    EXPECT_EQ(chart({"transfer", "--quick", "--csv", folder_.file("no/folder.csv")}).exit_code, 1);
    EXPECT_EQ(chart({"models", "--quick", "--scene", folder_.file("none.pbrt")}).exit_code, 1);
}

}  // namespace
}  // namespace emulsion::testing
