#include "spectrum/data_table.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/embedded_tables.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(DataTable, EveryEmbeddedTableParses) {
    ASSERT_GE(embedded_table_files().size(), 19u);
    for (const EmbeddedTableFile& file : embedded_table_files()) {
        const DataTable& table = data_table(file.name);
        EXPECT_EQ(table.name, file.name);
        EXPECT_GE(table.row_count(), 10u) << file.name;
        EXPECT_EQ(table.columns.size(), table.column_names.size()) << file.name;
        EXPECT_EQ(&table, &data_table(file.name)) << "parsed once";
    }
}

TEST(DataTable, ReadsNumbersAndNames) {
    const DataTable& observer = data_table("cie_1931_2deg_xyz_1nm");
    EXPECT_EQ(observer.row_count(), 471u);
    EXPECT_EQ(observer.column("wavelength").front(), 360.0);
    EXPECT_EQ(observer.column("xbar").front(), 0.0001299);
    EXPECT_EQ(observer.column("ybar").back(), 4.5181e-07);

    const DataTable& glasses = data_table("glasses");
    EXPECT_EQ(glasses.column("nd")[glasses.row("SF11")], 1.78472);
}

TEST(DataTable, MakesASpectrumOfAColumn) {
    const PiecewiseLinearSpectrum d65 = tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    EXPECT_EQ(d65.lambda_nm.size(), 107u);
    EXPECT_EQ(eval(d65, 560.0), 100.0);
}

TEST(DataTable, KeepsTheCommentLine) {
    EXPECT_THAT(data_table("colorchecker_reflectance").comment,
                AllOf(testing::StartsWith("spectral reflectance factor"), testing::EndsWith("ISO 17321-1:2012")));
    EXPECT_EQ(parse_data_table("t", "#\nwavelength,a\n400,1\n").comment, "");
    EXPECT_EQ(parse_data_table("t", "#a b\nwavelength,a\n400,1\n").comment, "a b");
}

TEST(DataTable, TakesMicrometresToNanometres) {
    EXPECT_THAT(wavelengths_nm(parse_data_table("t", "# t\nwavelength_um,a\n0.5,1\n0.75,2\n")),
                ElementsAre(500.0, 750.0));
    EXPECT_THAT(wavelengths_nm(parse_data_table("t", "# t\nwavelength,a\n0.5,1\n")), ElementsAre(0.5));
    EXPECT_THAT([] { (void)wavelengths_nm(data_table("glasses")); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("glasses"), HasSubstr("\"wavelength\""))));
}

TEST(DataTable, UnknownNamesListWhatExists) {
    EXPECT_THAT([] { (void)data_table("cie_1932"); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("\"cie_1932\""), HasSubstr("conductors_nk"))));
    EXPECT_THAT([] { (void)data_table("cornell_box").column("blue"); },
                ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("cornell_box"), HasSubstr("\"blue\""), HasSubstr("white, green, red"))));
    EXPECT_THAT([] { (void)data_table("glasses").row("window"); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("\"window\""), HasSubstr("fused_silica"))));
}

TEST(ParseDataTable, TakesTextWithAndWithoutALastLineEnd) {
    for (const char* text :
         {"# a table, so\nwavelength,a\n400,1\n410,-2.5e-1", "# \nwavelength,a\n400,1\n410,-0.25\n"}) {
        const DataTable table = parse_data_table("t", text);
        EXPECT_THAT(table.column_names, ElementsAre("wavelength", "a"));
        EXPECT_THAT(table.column("a"), ElementsAre(1.0, -0.25));
        EXPECT_TRUE(table.row_names.empty());
    }
}

TEST(ParseDataTable, MalformedTextNamesTableLineAndValue) {
    struct Case {
        std::string text, line, problem;
    };
    const std::vector<Case> cases = {
        {"", "line 1", "#"},
        {"wavelength,a\n400,1\n", "line 1", "#"},
        {"# t\nwavelength,a\n", "line 2", "at least one row"},
        {"# t\nwavelength,a\n400,1\n410,1x\n", "line 4", "\"1x\""},
        {"# t\nwavelength,a\n400,1\n410,\n", "line 4", "\"\""},
        {"# t\nwavelength,a\n400,nan\n", "line 3", "\"nan\""},
        {"# t\nwavelength,a\n400,1e999\n", "line 3", "\"1e999\""},
        {"# t\nwavelength,a\n400, 1\n", "line 3", "\" 1\""},
        {"# t\nwavelength,a\n400,1,2\n", "line 3", "3 cells: expected 2"},
        {"# t\nname,a\nx\n", "line 3", "1 cells: expected 2"},
        {"# t\nwavelength,a\n400,1\n\n410,1\n", "line 4", "1 cells"},
        {"# t\nwavelength,a\n400,1\n400,1\n", "line 4", "400"},
        {"# t\nwavelength_um,a\n0.4,1\n0.39,1\n", "line 4", "0.39"},
    };
    for (const Case& c : cases) {
        EXPECT_THAT([&] { (void)parse_data_table("my_table", c.text); },
                    ThrowsMessage<std::invalid_argument>(
                        AllOf(HasSubstr("my_table"), HasSubstr(c.line + ":"), HasSubstr(c.problem))))
            << c.text;
    }
}

}  // namespace
}  // namespace emulsion
