#include "cli/number_rows.h"

#include <array>
#include <limits>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace emulsion::cli {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::array<std::string_view, 3> kLab = {"L*", "a*", "b*"};

NumberRows parse(std::string_view text) { return parse_number_rows(text, "colours.csv", kLab); }

std::string problem_of(std::string_view text) {
    try {
        static_cast<void>(parse(text));
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

TEST(NumberRows, TakesCommasSemicolonsBlanksAndTabs) {
    for (const char* text : {"1 2 3\n4 5 6\n", "1,2,3\n4,5,6", "1;2;3\r\n4;5;6\r\n", " 1\t2 \t3 \n\n4 ,  5,\t6"}) {
        EXPECT_THAT(parse(text).values, ElementsAre(1, 2, 3, 4, 5, 6)) << text;
        EXPECT_EQ(parse(text).size(), 2u);
    }
    EXPECT_THAT(parse("").values, IsEmpty());
    EXPECT_THAT(parse("+1 -2.5e-3 .5").values, ElementsAre(1, -2.5e-3, 0.5));
}

TEST(NumberRows, PassesOverCommentsAndOneLineOfNames) {
    EXPECT_THAT(parse("# CIELAB\nL,a,b\n#\n1,2,3\n").values, ElementsAre(1, 2, 3));
    EXPECT_THAT(parse("\"L*\",\"a*\",\"b*\"\n1,2,3\n").values, ElementsAre(1, 2, 3));
    EXPECT_THAT(parse("nanometres,info,nano\n1,2,3\n").values, ElementsAre(1, 2, 3));
    EXPECT_EQ(problem_of("L,a,b\nL,a,b\n"),
              "colours.csv: row 1 (line 2): found \"L\" for L*, expected a finite number");
}

TEST(NumberRows, DoesNotTakeAMalformedFirstRowForNames) {
    for (const char* cell : {"nan", "-inf", "infinity", "1e999", "50%", "\"1\"", "'.5", "+x", "1.0f", "\"\""}) {
        const std::string row = std::string(cell) + "," + cell + "," + cell + "\n";
        EXPECT_EQ(problem_of(row + "1,2,3\n"),
                  "colours.csv: row 1 (line 1): found \"" + std::string(cell) + "\" for L*, expected a finite number");
    }
}

TEST(NumberRows, PassesOverAByteOrderMark) {
    EXPECT_THAT(parse("\xef\xbb\xbf"
                      "1,2,3\r\n")
                    .values,
                ElementsAre(1, 2, 3));
    EXPECT_THAT(parse("\xef\xbb\xbf"
                      "L,a,b\r\n1,2,3\r\n")
                    .values,
                ElementsAre(1, 2, 3));
}

TEST(NumberRows, WritesWithTheSeparatorOfTheFirstRow) {
    EXPECT_EQ(parse("1, 2, 3\n").separator, ',');
    EXPECT_EQ(parse("L,a,b\n1 2 3\n").separator, ',');
    EXPECT_EQ(parse("1 2 3\n").separator, ' ');
}

TEST(NumberRows, NamesTheRowTheCellAndWhatWasExpected) {
    EXPECT_EQ(problem_of("1 2 3\n\n4 five 6\n"),
              "colours.csv: row 2 (line 3): found \"five\" for a*, expected a finite number");
    EXPECT_EQ(problem_of("1 2\n"), "colours.csv: row 1 (line 1): found 2 cells, expected 3: L* a* b*");
    EXPECT_EQ(problem_of("1 2 3 4\n"), "colours.csv: row 1 (line 1): found 4 cells, expected 3: L* a* b*");
    EXPECT_EQ(problem_of("1,,3\n"), "colours.csv: row 1 (line 1): found \"\" for a*, expected a finite number");
    EXPECT_EQ(problem_of("1,2,\n"), "colours.csv: row 1 (line 1): found \"\" for b*, expected a finite number");
    for (const char* cell : {"nan", "inf", "-inf", "1e999", "0x10", "1.5f", "--1", "+-1", "1e"}) {
        EXPECT_EQ(problem_of("0 0 " + std::string(cell)),
                  "colours.csv: row 1 (line 1): found \"" + std::string(cell) + "\" for b*, expected a finite number");
    }
}

TEST(NumberRows, ReadsFilesAndNamesThemInErrors) {
    const TemporaryFolder folder;
    const std::string path = folder.file("lab.csv");
    write_text(path, "1,2,3\n");
    EXPECT_THAT(read_number_rows(path, kLab).values, ElementsAre(1, 2, 3));
    EXPECT_THROW(static_cast<void>(read_number_rows(folder.file("none.csv"), kLab)), IoError);
}

TEST(NumberRows, EveryDoubleSurvivesThePrinting) {
    const std::array<double, 3> row = {0.1, -1.0 / 3.0, std::numeric_limits<double>::denorm_min()};
    EXPECT_THAT(parse(number_row_text(row, ',')).values, ElementsAre(row[0], row[1], row[2]));
    EXPECT_EQ(number_row_text(row, ' ').substr(0, 20), "0.10000000000000001 ");
    EXPECT_EQ(number_row_text(std::array{1.0, 2.0}, ','), "1,2\n");
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(number_row_text(std::array{kNan, -kNan, -std::numeric_limits<double>::infinity()}, ' '),
              "nan nan -inf\n");
}

}  // namespace
}  // namespace emulsion::cli
