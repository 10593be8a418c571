// `emulsion color` as a user meets it.

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "run_program.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pointwise;
using ::testing::StartsWith;

class ColorProgram : public ::testing::Test {
  protected:
    /// The rows are given in a file.
    [[nodiscard]] ProgramResult run(std::vector<std::string> arguments, const std::string& rows) const {
        write_text(rows_, rows);
        arguments.insert(arguments.begin(), "color");
        arguments.push_back(rows_);
        return run_program(arguments);
    }
    [[nodiscard]] std::vector<double> numbers(const std::vector<std::string>& arguments,
                                              const std::string& rows) const {
        const ProgramResult result = run(arguments, rows);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return numbers_in(result.out);
    }
    [[nodiscard]] static std::vector<double> numbers_in(const std::string& text) {
        std::istringstream stream(text);
        std::vector<double> numbers;
        for (double number = 0.0; stream >> number;) numbers.push_back(number);
        EXPECT_TRUE(stream.eof()) << text;
        return numbers;
    }

    TemporaryFolder folder_;
    std::string rows_ = folder_.file("rows.txt");
};

ProgramResult color(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "color");
    return run_program(arguments);
}

/// Source of the values: FORMULAS of BT.709 with D65, IEC 61966-2-1; red in CIELAB as commonly tabulated (53.24 80.09
/// 67.20, D65).
TEST_F(ColorProgram, ConvertsRows) {
    EXPECT_THAT(numbers({"convert", "--from", "srgb", "--to", "xyz"}, "1 0 0\n0 1 0\n0 0 1\n"),
                Pointwise(DoubleNear(5e-7),
                          {0.412391, 0.212639, 0.019331, 0.357584, 0.715169, 0.119195, 0.180481, 0.072192, 0.950532}));
    EXPECT_THAT(numbers({"convert", "--from", "encoded-rgb", "--to", "lab"}, "1 0 0\n"),
                Pointwise(DoubleNear(0.005), {53.24, 80.09, 67.20}));
    EXPECT_THAT(numbers({"convert", "--from", "lab", "--to", "xyz", "--white", "A"}, "100 0 0\n"),
                Pointwise(DoubleNear(2e-4), {1.0985, 1.0, 0.3558}));
    EXPECT_THAT(numbers({"convert", "--from", "lab", "--to", "xyz", "--white", "0.25,0.5"}, "100 0 0\n"),
                Pointwise(DoubleNear(1e-12), {0.5, 1.0, 0.5}));
}

/// White stays grey when its system's white is adapted to, whatever the two are; without, nothing is adapted.
TEST_F(ColorProgram, AdaptsOnTheWayIfAsked) {
    EXPECT_THAT(numbers({"convert", "--from", "encoded-rgb", "--to", "lab", "--white", "D50", "--adapt", "bradford"},
                        "1 1 1\n"),
                Pointwise(DoubleNear(1e-12), {100.0, 0.0, 0.0}));
    EXPECT_THAT(
        numbers({"convert", "--from", "lab", "--to", "acescg-ap1", "--white", "A", "--adapt", "cat16"}, "100 0 0\n"),
        Pointwise(DoubleNear(1e-12), {1.0, 1.0, 1.0}));
    EXPECT_THAT(numbers({"convert", "--from", "dci-p3", "--to", "ictcp", "--adapt", "cat02"}, "1 1 1\n"),
                Pointwise(DoubleNear(1e-5), {0.58069, 0.0, 0.0}));  // PQ of 203 cd/m^2 (ITU-R BT.2408)
    EXPECT_THAT(numbers({"convert", "--from", "srgb", "--to", "xyz", "--white", "D50"}, "1 1 1\n"),
                Pointwise(DoubleNear(1e-10), {0.9504559271, 1.0, 1.0890577508}));  // 0.3127 0.329
    EXPECT_EQ(color({"convert", "--from", "srgb", "--to", "xyz", "--adapt", "cat17"}).exit_code, 2);
}

TEST_F(ColorProgram, WarnsOfWhatHasNoNumbersInTheSystem) {
    const ProgramResult result = run({"convert", "--from", "xyz", "--to", "xyy"}, "1 1 1\n1 0 -1\n0 0 0\n2 0 -2\n");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "emulsion: warning: 2 of 4 rows came out with numbers that aren't finite, row 2 first\n");
}

TEST_F(ColorProgram, AStandardInputThatIsClosedIsNoEmptyOne) {
    const ProgramResult result =
        run_program({"color", "convert", "--from", "xyz", "--to", "lab"}, {.before = [] { ::close(STDIN_FILENO); }});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, StartsWith("emulsion: error: standard input: reading failed: "));
}

TEST_F(ColorProgram, RowsSurviveTheWayThereAndBack) {
    const std::string rows = "0.10000000000000001 0.20000000000000001 0.69999999999999996\n";
    const ProgramResult there = run({"convert", "--from", "rec2020", "--to", "oklab"}, rows);
    EXPECT_THAT(numbers({"convert", "--from", "oklab", "--to", "rec2020"}, there.out),
                Pointwise(DoubleNear(1e-12), {0.1, 0.2, 0.7}));
}

TEST_F(ColorProgram, ConvertsBetweenSystemsOfThreeAndFour) {
    EXPECT_THAT(numbers({"convert", "--from", "encoded-rgb", "--to", "cmyk"}, "0.5 0.25 0.5\n"),
                Pointwise(DoubleNear(1e-12), {0.0, 0.5, 0.0, 0.5}));
    EXPECT_THAT(numbers({"convert", "--from", "cmyk", "--to", "encoded-rgb"}, "0 0.5 0 0.5\n"),
                Pointwise(DoubleNear(1e-12), {0.5, 0.25, 0.5}));
}

TEST_F(ColorProgram, ReadsStandardInput) {
    write_text(rows_, "1 1 1\n");
    const auto from_file = [this] {
        const int file = ::open(rows_.c_str(), O_RDONLY);
        if (::dup2(file, STDIN_FILENO) < 0) ::_exit(126);
    };
    for (const char* name : {"-", ""}) {
        std::vector<std::string> arguments = {"color", "convert", "--from", "xyz", "--to", "xyy"};
        if (*name != '\0') arguments.emplace_back(name);
        const ProgramResult result = run_program(arguments, {.before = from_file});
        EXPECT_THAT(numbers_in(result.out), Pointwise(DoubleNear(1e-15), {1.0 / 3.0, 1.0 / 3.0, 1.0})) << result.err;
    }
}

TEST_F(ColorProgram, CommasStayCommas) {
    EXPECT_EQ(run({"encode", "--transfer", "linear"}, "R,G,B\n0.25,0.5,1\n").out, "0.25,0.5,1\n");
}

TEST_F(ColorProgram, MalformedRowsAreNamedAndNothingIsWritten) {
    const ProgramResult result = run({"convert", "--from", "lab", "--to", "xyz"}, "50 0 0\n50 zero 0\n");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err,
              "emulsion: error: " + rows_ + ": row 2 (line 2): found \"zero\" for a*, expected a finite number\n");
}

/// The first pair of Sharma, Wu & Dalal (2005); and hand-made ones.
TEST_F(ColorProgram, MeasuresDifferences) {
    const std::string pair = "50,2.6772,-79.7751,50,0,-82.7485\n";
    EXPECT_THAT(numbers({"difference"}, pair), Pointwise(DoubleNear(5e-5), {2.0425}));
    EXPECT_THAT(numbers({"difference", "--method", "cie76"}, "0 0 0 3 4 12\n"), ElementsAre(13.0));
    EXPECT_THAT(numbers({"difference", "--method", "cmc:l=1,c=1"}, "50 0 0 50 0 0\n"), ElementsAre(0.0));
    EXPECT_THAT(numbers({"difference", "--method", "itp"}, "0 0 0 0.3 0 0.4\n"), Pointwise(DoubleNear(1e-9), {360.0}));
}

/// White goes to white; the matrix is Lindbloom's for A to D65 by Bradford, to its digits.
TEST_F(ColorProgram, Adapts) {
    EXPECT_THAT(numbers({"adapt", "--from", "0.4475726770835456,0.407439851691894", "--to",
                         "0.3127266146810121,0.32902313032606195"},
                        "1 0 0\n0 1 0\n0 0 1\n"),
                Pointwise(DoubleNear(2e-7), {0.8446965, -0.1366303, 0.0798489, -0.1179225, 1.1041226, -0.1348999,
                                             0.3948108, 0.1291718, 3.1924009}));
    EXPECT_THAT(numbers({"adapt", "--from", "0.4,0.4", "--to", "0.3,0.3", "--method", "xyz-scaling", "--degree", "0"},
                        "0.1 0.2 0.3\n"),
                ElementsAre(0.1, 0.2, 0.3));
}

/// Middle grey of sRGB: 0.5 is the code of 0.21404 (IEC 61966-2-1).
TEST_F(ColorProgram, EncodesAndDecodes) {
    EXPECT_THAT(numbers({"decode"}, "0.5\n"), Pointwise(DoubleNear(5e-6), {0.21404}));
    EXPECT_THAT(numbers({"encode", "--transfer", "Gamma:Exponent=2"}, "0.25 0.49 1 4\n"),
                Pointwise(DoubleNear(1e-12), {0.5, 0.7, 1.0, 2.0}));
    EXPECT_THAT(numbers({"encode", "--transfer", "pq"}, "0.01\n"), Pointwise(DoubleNear(1e-6), {0.508078}));
}

TEST_F(ColorProgram, PrintsMatrices) {
    const ProgramResult matrix = color({"matrix", "--from", "sRGB", "--to", "XYZ"});
    EXPECT_EQ(matrix.exit_code, 0) << matrix.err;
    EXPECT_THAT(numbers_in(matrix.out), Pointwise(DoubleNear(5e-7), {0.412391, 0.357584, 0.180481, 0.212639, 0.715169,
                                                                     0.072192, 0.019331, 0.119195, 0.950532}));
    // From one display to another: with its white adapted, white stays white.
    const std::vector<double> m =
        numbers_in(color({"matrix", "--from", "sRGB", "--to", "DCI-P3", "--adapt", "bradford"}).out);
    ASSERT_EQ(m.size(), 9u);
    for (std::size_t row = 0; row < 3; ++row) EXPECT_NEAR(m[3 * row] + m[3 * row + 1] + m[3 * row + 2], 1.0, 1e-12);
    // That of ICC profiles: Lindbloom's sRGB for D50, whose whites have five digits of XYZ.
    EXPECT_THAT(
        numbers_in(color({"matrix", "--from", "sRGB", "--to", "XYZ", "--white", "D50", "--adapt", "bradford"}).out),
        Pointwise(DoubleNear(1e-4),
                  {0.4360747, 0.3850649, 0.1430804, 0.2225045, 0.7168786, 0.0606169, 0.0139322, 0.0971045, 0.7141733}));
    const ProgramResult none = color({"matrix", "--from", "sRGB", "--to", "lab"});
    EXPECT_EQ(none.exit_code, 1);
    EXPECT_THAT(none.err, HasSubstr("is not linear"));
}

TEST_F(ColorProgram, DescribesSpectra) {
    const ProgramResult text = color({"spectrum", "d65"});
    EXPECT_EQ(text.exit_code, 0) << text.err;
    EXPECT_THAT(text.out, AllOf(StartsWith("spectrum                 D65\n"),
                                ContainsRegex("x y Y .Y in cd/m.2. +0\\.3127[0-9]* 0\\.3290[0-9]* "),
                                ContainsRegex("colour temperature, K +650[234]\\."), ContainsRegex("Ra +99\\.9")));
    const ProgramResult json = color({"spectrum", "colorchecker-red", "--illuminant", "FL11", "--json"});
    EXPECT_THAT(json.out, AllOf(StartsWith("{\n  \"spectrum\": \"colorchecker-red\",\n"),
                                HasSubstr("\"illuminant\": \"FL11\""), HasSubstr("\"luminance_cdm2\": null"),
                                ContainsRegex("\"XYZ\": \\[0\\.[0-9]+, 0\\.[0-9]+, 0\\.[0-9]+\\]")));
}

/// Equal energy of 1 W m^-2 sr^-1 nm^-1: 683 times the sum of ybar at 1 nm (106.856917), whose integral by straight
/// lines it is, as ybar is all but 0 at the ends.
TEST_F(ColorProgram, DescribesFiles) {
    const ProgramResult light = run({"spectrum"}, "wavelength,radiance\n360,1\n830,1\n");
    EXPECT_EQ(light.exit_code, 0) << light.err;
    EXPECT_THAT(light.out, ContainsRegex("luminance, cd/m\\^2 +72983\\.27"));
    const ProgramResult grey = run({"spectrum", "--illuminant", "A"}, "360 0.25\n830 0.25\n");
    EXPECT_THAT(grey.out, ContainsRegex("X Y Z +0\\.2746[0-9]* 0\\.25 "));
    const ProgramResult wrong = run({"spectrum"}, "400 1\n400 2\n");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_THAT(wrong.err, HasSubstr("row 2: found wavelength 400, expected more than the 400 before it"));
}

/// A sum of no light, of too few rows, and of wavelengths in micrometres.
TEST_F(ColorProgram, SaysNothingOfWhatASpectrumHasNot) {
    const ProgramResult black = run({"spectrum", "--json"}, "400 0\n700 0\n");
    EXPECT_EQ(black.exit_code, 0) << black.err;
    EXPECT_THAT(black.out,
                AllOf(HasSubstr("\"XYZ\": [0, 0, 0]"), HasSubstr("\"xyY\": [null, null, 0]"),
                      HasSubstr("\"Lab\": null"), HasSubstr("\"excitation_purity\": null"), HasSubstr("\"Ra\": null")));
    EXPECT_THAT(run({"spectrum"}, "400 0\n700 0\n").out, HasSubstr("x y Y (Y in cd/m^2)      none none 0\n"));
    EXPECT_THAT(run({"spectrum", "--illuminant", "A", "--json"}, "400 0\n700 0\n").out,
                AllOf(HasSubstr("\"Lab\": [0, 0, 0]"), HasSubstr("\"excitation_purity\": null")));
    // Less light than none has no hue and no temperature.
    EXPECT_THAT(run({"spectrum", "--json"}, "400 -1\n700 -2\n").out,
                AllOf(HasSubstr("\"Lab\": null"), HasSubstr("\"cct_K\": null"), HasSubstr("\"Ra\": null")));
    // A green line is far from every blackbody, and the index is made for lights near them.
    EXPECT_THAT(run({"spectrum", "--json"}, "550 1\n551 1\n").out,
                AllOf(HasSubstr("\"cct_K\": null"), HasSubstr("\"Ra\": null")));
    const ProgramResult one = run({"spectrum"}, "555 1\n");
    EXPECT_EQ(one.exit_code, 1);
    EXPECT_THAT(one.err, HasSubstr("has 1 row, expected two or more"));
    const ProgramResult micrometres = run({"spectrum"}, "0.4 1\n0.7 1\n");
    EXPECT_EQ(micrometres.exit_code, 1);
    EXPECT_THAT(micrometres.err, HasSubstr("expected nanometres, some of them in 360-830"));
}

TEST_F(ColorProgram, ListsEveryName) {
    const ProgramResult all = color({"list"});
    EXPECT_EQ(all.exit_code, 0);
    for (const char* name : {"oklab", "Rec2020", "cmc", "cat16", "bt1886", "cie_1964_10deg", "LED_RGB1", "ampas",
                             "glass-N_BK7", "colorchecker-dark-skin", "metal-CuZn-k", "ciede2000", "itp"}) {
        EXPECT_THAT(all.out, HasSubstr(name));
    }
    const ProgramResult some = color({"list", "Transfers"});
    EXPECT_THAT(some.out, AllOf(HasSubstr("srgb"), ::testing::Not(HasSubstr("oklab"))));
}

TEST_F(ColorProgram, UnknownNamesAreBadUsageOrErrorsThatSayWhatIsLikeThem) {
    const ProgramResult space = color({"convert", "--from", "oklap", "--to", "xyz"});
    EXPECT_EQ(space.exit_code, 2);
    EXPECT_THAT(space.err, HasSubstr("oklab"));
    EXPECT_EQ(color({"adapt", "--from", "D66", "--to", "A"}).exit_code, 2);
    EXPECT_EQ(color({"difference", "--method", "ciede2001"}).exit_code, 2);
    EXPECT_EQ(color({"convert", "--from", "xyz"}).exit_code, 2);
    EXPECT_EQ(color({"list", "nothing"}).exit_code, 2);
    EXPECT_EQ(color({"adapt", "--from", "D65", "--to", "A", "--degree", "nan"}).exit_code, 2);
    EXPECT_EQ(color({"adapt", "--from", "D65", "--to", "A", "--degree", "1.1"}).exit_code, 2);
    for (const char* white : {"0,0", "0.9,0.9", "-0.1,0.5", "nan,0.3", "0.3", "0.3,0.3,0.3", "", "colorchecker-red"}) {
        EXPECT_EQ(color({"convert", "--from", "xyz", "--to", "lab", "--white", white}).exit_code, 2) << white;
        EXPECT_EQ(color({"spectrum", "D65", "--white", white}).exit_code, 2) << white;
    }
    EXPECT_EQ(color({"spectrum", "colorchecker-red", "--illuminant", "D66"}).exit_code, 2);
    EXPECT_EQ(color({"spectrum", "colorchecker-red", "--observer", "mine"}).exit_code, 2);
    EXPECT_EQ(color({}).exit_code, 2);
    const ProgramResult spectrum = color({"spectrum", "colourchecker-red"});
    EXPECT_EQ(spectrum.exit_code, 1);
    EXPECT_THAT(spectrum.err, HasSubstr("colorchecker-red"));
    const ProgramResult index = color({"spectrum", "glass-N_BK7"});
    EXPECT_EQ(index.exit_code, 1);
    EXPECT_THAT(index.err, HasSubstr("expected a reflectance or a light"));
}

}  // namespace
}  // namespace emulsion::testing
