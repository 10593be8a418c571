#include "film/pfm_file.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "spectrum/rgb_space.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using std::string_literals::operator""s;

const std::string kOne = "\x3f\x80\0\0"s, kTwo = "\x40\0\0\0"s, kOneLittle = "\0\0\x80\x3f"s,
                  kTwoLittle = "\0\0\0\x40"s;

/// Rec. 709 with so many cd/m^2, as XYZ.
XYZ xyz_of_rgb(const RGBd& rgb) {
    const auto xyz = xyz_from_rgb(rgb_space("Rec709")) * std::array{rgb.r, rgb.g, rgb.b};
    return {static_cast<float>(xyz[0]), static_cast<float>(xyz[1]), static_cast<float>(xyz[2])};
}

void expect_near(const XYZ& found, const XYZ& expected, double tolerance) {
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
    EXPECT_NEAR(found.z, expected.z, tolerance);
}

std::string message_of(const std::string& bytes) {
    const TemporaryFolder folder;
    write_text(folder.file("a.pfm"), bytes);
    try {
        (void)read_pfm(folder.file("a.pfm"));
        return "no error";
    } catch (const IoError& error) {
        EXPECT_EQ(error.path(), folder.file("a.pfm"));
        return error.reason();
    }
}

TEST(PfmFile, WritesRec709FromTheBottomUp) {
    const TemporaryFolder folder;
    Image<XYZ> xyz(1, 2);
    xyz(0, 0) = xyz_of_rgb({1, 0, 0});
    xyz(0, 1) = xyz_of_rgb({0, 0, 2});
    write_pfm(folder.file("a.pfm"), xyz);
    const std::string bytes = read_text(folder.file("a.pfm"));
    ASSERT_EQ(bytes.size(), 12u + 24u);
    EXPECT_EQ(bytes.substr(0, 12), "PF\n1 2\n-1.0\n");
    // The lower row first. Float XYZ gives 2 back to a few units in the last place: the exponent is 2's or the next
    // below.
    EXPECT_THAT(bytes[12 + 11], testing::AnyOf('\x40', '\x3f'));
    EXPECT_THAT(folder.names(), ElementsAre("a.pfm"));
    // And read again: Rec. 709, at 1 cd/m^2.
    const ScenePicture read = read_pfm(folder.file("a.pfm"));
    expect_near(read.xyz(0, 0), xyz(0, 0), 1e-6);
    expect_near(read.xyz(0, 1), xyz(0, 1), 1e-6);
    EXPECT_THAT(read.notes, ElementsAre(HasSubstr("Rec. 709"), HasSubstr("1 cd/m^2")));
}

TEST(PfmFile, HoldsEveryValue) {
    const TemporaryFolder folder;
    Image<XYZ> xyz(3, 1);
    xyz(0, 0) = {std::numeric_limits<float>::quiet_NaN(), 1.0f, 1.0f};
    xyz(1, 0) = {0.1f, 0.3f, 0.02f};  // outside Rec. 709
    xyz(2, 0) = xyz_of_rgb({3e30, 2e30, 1e30});
    write_pfm(folder.file("a.pfm"), xyz, {.white_luminance_cdm2 = 100.0});
    const ScenePicture read = read_pfm(folder.file("a.pfm"));
    EXPECT_TRUE(std::isnan(read.xyz(0, 0).y));
    expect_near(read.xyz(1, 0), {0.001f, 0.003f, 0.0002f}, 1e-9);
    EXPECT_NEAR(read.xyz(2, 0).y / xyz(2, 0).y, 0.01, 1e-8);
}

TEST(PfmFile, ReadsBothByteOrdersColourAndGrey) {
    const TemporaryFolder folder;
    const auto read = [&](const std::string& bytes) {
        write_text(folder.file("a.pfm"), bytes);
        return read_pfm(folder.file("a.pfm"));
    };
    const XYZ color = xyz_of_rgb({1, 2, 1}), white = xyz_of_rgb({2, 2, 2});
    expect_near(read("PF 1 1 1\n" + kOne + kTwo + kOne).xyz(0, 0), color, 1e-6);
    expect_near(read("PF\n1 1\n-1\n" + kOneLittle + kTwoLittle + kOneLittle).xyz(0, 0), color, 1e-6);
    EXPECT_EQ(read("Pf\r\n1 2\r\n1.0\r\n" + kOne + kTwo).xyz, read("Pf\n1 2\n1.0\n" + kOne + kTwo).xyz);
    const ScenePicture grey = read("Pf\n1\t2\r\n1.0\n" + kOne + kTwo);
    EXPECT_EQ(grey.xyz.height(), 2);
    expect_near(grey.xyz(0, 0), white, 1e-6);  // the second in the file
    expect_near(grey.xyz(0, 1), xyz_of_rgb({1, 1, 1}), 1e-6);
    EXPECT_THAT(read("Pf 1 1 2.5 " + kOne + "\n").notes, ElementsAre(HasSubstr("Rec. 709"), HasSubstr("1 cd/m^2"),
                                                                     HasSubstr("scale of 2.5"), HasSubstr("behind")));
}

TEST(PfmFile, ErrorsNamePlaceValueAndWhatWasExpected) {
    EXPECT_EQ(message_of("P7 1 1 1 "), "PFM header, byte 0: found \"P7\", expected PF or Pf");
    EXPECT_EQ(message_of("PF 0 1 1 "), "PFM header, byte 3: found \"0\", expected a width of at least 1");
    EXPECT_EQ(message_of("PF 1 1x 1 "), "PFM header, byte 5: found \"1x\", expected a height of at least 1");
    EXPECT_THAT(message_of("PF 1 1 0 "), HasSubstr("found 0, expected a scale that is not 0"));
    EXPECT_THAT(message_of("PF 1 1 nan "), HasSubstr("found \"nan\", expected a scale that is not 0"));
    EXPECT_THAT(message_of("PF 1 1 "), HasSubstr("found the end of the file, expected a scale"));
    EXPECT_THAT(message_of("PF 1 " + std::string(50, '1')), HasSubstr("more than 40 characters"));
    EXPECT_EQ(message_of("PF 2 3 1\n123"), "PFM of 2x3 pixels: found 3 bytes of samples, expected 6 times 12");
    EXPECT_THAT(message_of("PF 2147483647 2147483647 1\n123"), HasSubstr("found 3 bytes of samples"));
}

TEST(PfmFile, WritesWholeOrNotAtAll) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_pfm(folder.file("nowhere") + "/a.pfm", Image<XYZ>(1, 1)), IoError);
    EXPECT_THROW(write_pfm(folder.file("a.pfm"), Image<XYZ>()), std::invalid_argument);
    EXPECT_THROW(write_pfm(folder.file("a.pfm"), Image<XYZ>(1, 1), {.white_luminance_cdm2 = 0.0}),
                 std::invalid_argument);
    EXPECT_THAT(folder.names(), IsEmpty());
}

}  // namespace
}  // namespace emulsion
