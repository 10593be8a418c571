#include "spectrum/table_transfer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/text_file.h"
#include "spectrum/transfer_function.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

std::string csv_error(const std::string& csv) {
    try {
        (void)parse_table_transfer("x", csv);
        return "none";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

std::string points_error(const std::string& text) {
    try {
        (void)parse_named<TransferFunction>(text, "transfer");
        return "none";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(TableTransfer, RunsStraightBetweenItsPoints) {
    const TableTransfer table{{{0.0, 0.0}, {0.5, 0.25}, {1.0, 1.0}}};
    EXPECT_EQ(decode(table, 0.25), 0.125);
    EXPECT_EQ(decode(table, 0.5), 0.25);
    EXPECT_EQ(decode(table, 0.75), 0.625);
    EXPECT_EQ(encode(table, 0.125), 0.25);
    EXPECT_EQ(encode(table, 0.25), 0.5);
    EXPECT_EQ(encode(table, 0.625), 0.75);
    EXPECT_EQ(decode(table, 1.5), 1.75);
    EXPECT_EQ(encode(table, 1.75), 1.5);
    EXPECT_EQ(encode(table, -0.125), -0.25);
}

TEST(TableTransfer, EncodeIsTheInverse) {
    TableTransfer table;
    table.points.clear();
    for (int i = 0; i <= 37; ++i) table.points.push_back({i / 37.0, std::pow(i / 37.0, 2.4)});
    double before = -1.0;
    for (int i = 0; i <= 100000; ++i) {
        const double code = i / 100000.0, light = decode(table, code);
        EXPECT_GE(light, before);
        before = light;
        ASSERT_NEAR(encode(table, light), code, 1e-14);
    }
    for (const TablePoint& point : table.points) {
        EXPECT_EQ(decode(table, point.x), point.y);
        EXPECT_EQ(encode(table, point.y), point.x);
    }
}

TEST(TableTransfer, SeventeenPointsOfAPowerAreAsFarOffAsTheHeaderSays) {
    TableTransfer table;
    table.points.clear();
    for (int i = 0; i <= 16; ++i) table.points.push_back({i / 16.0, std::pow(i / 16.0, 2.2)});
    double worst = 0.0;
    for (int i = 0; i <= 10000; ++i) {
        worst = std::max(worst, std::abs(decode(table, i / 10000.0) - std::pow(i / 10000.0, 2.2)));
    }
    EXPECT_NEAR(worst, 0.0013, 0.00005);
}

TEST(TableTransfer, OfCodesThatShowTheSameTheLeastIsSent) {
    const TableTransfer table{{{0.0, 0.0}, {0.1, 0.0}, {0.5, 0.25}, {0.6, 0.25}, {1.0, 1.0}}};
    EXPECT_EQ(encode(table, 0.0), 0.0);
    EXPECT_EQ(encode(table, 0.25), 0.5);
    EXPECT_GT(encode(table, 0.2501), 0.6);
    EXPECT_GT(encode(table, 1e-9), 0.1);
}

TEST(TableTransfer, ReadsWhatWasMeasured) {
    const TableTransfer expected{{{0.0, 0.0}, {0.5, 0.25}, {1.0, 1.0}}};
    EXPECT_EQ(parse_table_transfer("x", "0,0.5\n128,25.5\n256,100.5\n"), expected);
    EXPECT_EQ(parse_table_transfer(
                  "x", "\xef\xbb\xbf# a meter's\r\n\r\n code , luminance\r\n0, 0.5\r\n 128,25.5\r\n256,100.5"),
              expected);
    EXPECT_EQ(parse_named<TransferFunction>("table:0=0,0.5=0.25,1=1", "transfer"), TransferFunction(expected));
    EXPECT_EQ(to_text(TransferFunction(expected)), "table:0=0,0.5=0.25,1=1");
    EXPECT_EQ(to_text(TransferFunction(TableTransfer{})), "table:0=0,1=1");
    EXPECT_EQ(parse_named<TransferFunction>("table", "transfer"), TransferFunction(TableTransfer{}));
}

TEST(TableTransfer, WrongTablesNameLineValueAndWhatWasExpected) {
    EXPECT_EQ(csv_error(""), "transfer table x: line 1: the text ends here, expected two rows or more");
    EXPECT_EQ(csv_error("0,0\n"), "transfer table x: line 1: the text ends here, expected two rows or more");
    EXPECT_EQ(csv_error("a,b\n0,0\n1,x\n"), "transfer table x: line 3: luminance is \"x\", expected a finite number");
    EXPECT_EQ(csv_error("0,0\nnan,1\n"), "transfer table x: line 2: code is \"nan\", expected a finite number");
    EXPECT_EQ(csv_error("0,0\n1\n"),
              "transfer table x: line 2: \"1\", expected two cells with a comma between: code, luminance");
    EXPECT_EQ(csv_error("0,0\n5,1\n5,2\n"), "transfer table x: line 3: code is 5, expected more than 5");
    EXPECT_EQ(csv_error("0,0\n5,2\n6,1.5\n"),
              "transfer table x: line 3: luminance is 1.5, expected 2 or more, as curves don't fall");
    EXPECT_EQ(csv_error("0,2\n5,2\n"), "transfer table x: the luminances of all rows are 2, expected a rise");
    EXPECT_EQ(csv_error("0,0\n5,2\n6,2\n"),
              "transfer table x: the table: point 3 is 1=1, expected less light before it: the last piece must rise");
    EXPECT_EQ(points_error("table:0=0,0.5=x,1=1"), "transfer table: point 2 = \"x\": not a number");
    EXPECT_EQ(points_error("table:0=0"), "transfer table: number of points = 1: must be in [2, 1024]");
    EXPECT_EQ(points_error("table:0=0,0.5=0.6,1=0.9"), "transfer table: point 3 is 1=0.9, expected 1=1 at the end");
    EXPECT_EQ(points_error("table:0=0.1,1=1"), "transfer table: point 1 is 0=0.1, expected 0=0");
    EXPECT_EQ(points_error("table:0=0,0.6=0.5,0.5=0.7,1=1"),
              "transfer table: point 3 is 0.5=0.7, expected a code above 0.6");
}

TEST(TableTransfer, FilesAreReadAndNamedInErrors) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "curve.csv";
    write_text_file(path, "0,0\n1,2\n");
    EXPECT_EQ(read_table_transfer(path), TableTransfer{});
    write_text_file(path, "0,0\n1,-2\n");
    EXPECT_THAT([&] { (void)read_table_transfer(path); },
                testing::ThrowsMessage<IoError>(path.string() +
                                                ": line 2: luminance is -2, expected 0 or more, as curves don't fall"));
    EXPECT_THROW((void)read_table_transfer(folder.path() / "none.csv"), IoError);
}

}  // namespace
}  // namespace emulsion
