#include "film/camera_response.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/units.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

const std::string kGood = "wavelength,r,g,b\n400,0,0.25,1\n500,0.5,1,0.5\n600,1,0.5,0\n";

TEST(CameraCsv, IsReadAsItStands) {
    const CameraResponse camera = parse_camera_response("test", kGood);
    EXPECT_EQ(camera.name, "test");
    EXPECT_EQ(camera.lambda_nm, (std::vector<double>{400, 500, 600}));
    EXPECT_EQ(camera.value, (std::vector<RGBd>{{0, 0.25, 1}, {0.5, 1, 0.5}, {1, 0.5, 0}}));
}

// What spreadsheets and other systems make of the same table.
TEST(CameraCsv, TakesOtherWaysToWriteTheSame) {
    const CameraResponse expected = parse_camera_response("test", kGood);
    for (const std::string& text :
         {std::string("# measured 2024\n\nWavelength , R,\tG, B\n 400 , 0,0.25,1\n\n500,.5,1,5e-1\n# end\n600,1,0.5,0"),
          std::string("wavelength,r,g,b\r\n400,0,0.25,1\r\n500,0.5,1,0.5\r\n600,1,0.5,0\r\n"),
          std::string("\xef\xbb\xbf") + kGood,
          std::string("b,wavelength,g,r\n1,400,0.25,0\n0.5,500,1,0.5\n0,600,0.5,1\n")}) {
        EXPECT_EQ(parse_camera_response("test", text), expected) << text;
    }
}

struct BadCsv {
    std::string text, message;
};

TEST(CameraCsv, BadOnesSayWhereAndWhat) {
    const BadCsv all[] = {
        {"", "line 1: the text ends here, expected the names wavelength,r,g,b"},
        {"# nothing\n", "line 1: the text ends here, expected the names wavelength,r,g,b"},
        {"wavelength,r,g\n400,1,1\n", R"(line 1: "wavelength,r,g" has 3 cells, expected four, with commas between)"},
        {"wavelength;r;g;b\n", R"(line 1: "wavelength;r;g;b" has 1 cells, expected four, with commas between)"},
        {"wavelength,r,g,g\n", R"(line 1: "wavelength,r,g,g" has no column "b", expected the names wavelength,r,g,b)"},
        {"400,0,0.25,1\n500,0.5,1,0.5\n",
         R"(line 1: "400,0,0.25,1" has no column "wavelength", expected the names wavelength,r,g,b)"},
        {"wavelength,r,g,b\n400,0,x,1\n", R"(line 2: g is "x", expected a finite number)"},
        {"wavelength,r,g,b\n400,0,0.25,\n", R"(line 2: b is "", expected a finite number)"},
        {"wavelength,r,g,b\n400,nan,0,1\n", R"(line 2: r is "nan", expected a finite number)"},
        {"wavelength,r,g,b\n400,inf,0,1\n", R"(line 2: r is "inf", expected a finite number)"},
        {"wavelength,r,g,b\n400,1e999,0,1\n", R"(line 2: r is "1e999", expected a finite number)"},
        {"wavelength,r,g,b\n400,0 1,0,1\n", R"(line 2: r is "0 1", expected a finite number)"},
        {"# a comment\nwavelength,r,g,b\n\n400,0,0,1\n400,1,1,1\n",
         "line 5: wavelength is 400, expected more than 400"},
        {"wavelength,r,g,b\n400,0,0,1\n390,1,1,1\n", "line 3: wavelength is 390, expected more than 400"},
        {"wavelength,r,g,b\n-5,0,0,1\n", "line 2: wavelength is -5, expected more than 0"},
        {"wavelength,r,g,b\n400,0,0,1,2\n", R"(line 2: "400,0,0,1,2" has 5 cells, expected four, with commas between)"},
        {"wavelength,r,g,b\n400,1,1,1\n", "line 2: the text ends here, expected at least two rows"},
        {"wavelength,r,g,b\n0.4,1,1,1\n0.7,1,1,1\n",
         "wavelengths from 0.4 to 0.7, expected at least two nm of the visible range, 360 to 830 nm"},
        {"wavelength,r,g,b\n500.2,1,1,1\n501.8,1,1,1\n",
         "wavelengths from 500.2 to 501.8, expected at least two nm of the visible range, 360 to 830 nm"},
        {"wavelength,r,g,b\n400,0,0,1\n500,0,1,1\n",
         "r is 0 over the visible range, 360 to 830 nm, expected a response"},
    };
    const TemporaryFolder folder;
    const std::string path = folder.file("camera.csv");
    for (const BadCsv& bad : all) {
        EXPECT_THAT([&] { static_cast<void>(parse_camera_response("test", bad.text)); },
                    ThrowsMessage<std::invalid_argument>("camera test: " + bad.message));
        write_text(path, bad.text);
        EXPECT_THAT([&] { static_cast<void>(read_camera_response(path)); },
                    ThrowsMessage<IoError>(path + ": " + bad.message));
    }
    EXPECT_THAT([&] { static_cast<void>(read_camera_response(folder.file("none.csv"))); },
                ThrowsMessage<IoError>(StartsWith(folder.file("none.csv") + ": ")));
}

TEST(CameraCsv, IsReadFromAFile) {
    const TemporaryFolder folder;
    write_text(folder.file("camera.csv"), kGood);
    const CameraResponse camera = read_camera_response(folder.file("camera.csv"));
    EXPECT_EQ(camera.name, folder.file("camera.csv"));
    EXPECT_EQ(camera.value, parse_camera_response("test", kGood).value);
}

TEST(CameraResponse, StandsAtWholeNanometres) {
    const Observer curves = at_whole_nm(parse_camera_response("test", kGood));
    EXPECT_EQ(curves.first_nm, 400);
    EXPECT_EQ(curves.last_nm(), 600);
    EXPECT_EQ(eval(curves, 400.0), (XYZd{0.0, 0.25, 1.0}));
    EXPECT_EQ(eval(curves, 450.0), (XYZd{0.25, 0.625, 0.75}));
    EXPECT_EQ(eval(curves, 600.0), (XYZd{1.0, 0.5, 0.0}));
    EXPECT_EQ(eval(curves, 600.5), XYZd{});
}

// Rows between whole nanometres, and outside the range: the straight lines at the whole ones of the range.
TEST(CameraResponse, IsCutToTheRange) {
    const CameraResponse wide{"wide", {300.5, 1000.5}, {{300.5, 601.0, 1.0}, {1000.5, 2001.0, 1.0}}};
    const Observer curves = at_whole_nm(wide);
    EXPECT_EQ(curves.first_nm, kMinWavelength_nm);
    EXPECT_EQ(curves.last_nm(), kMaxWavelength_nm);
    for (int nm = kMinWavelength_nm; nm <= kMaxWavelength_nm; ++nm) {
        EXPECT_NEAR(eval(curves, nm).x, nm, 1e-10);
        EXPECT_NEAR(eval(curves, nm).y, 2.0 * nm, 1e-10);
        EXPECT_NEAR(eval(curves, nm).z, 1.0, 1e-14);
    }
}

TEST(CameraResponse, RefusesWhatIsOutOfRange) {
    const auto refused = [](const CameraResponse& camera, const std::string& what) {
        EXPECT_THAT([&] { validate(camera); },
                    ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("camera bad"), HasSubstr(what))));
    };
    refused({"bad", {}, {}}, "at least two nm");
    refused({"bad", {400, 500}, {{1, 1, 1}}}, "2 wavelengths and 1 values");
    refused({"bad", {500, 400}, {{1, 1, 1}, {1, 1, 1}}}, "lambda_nm[1]");
    refused({"bad", {400, 500}, {{1, 1, 1}, {1, HUGE_VAL, 1}}}, "value[1]");
    refused({"bad", {400, 500}, {{1, 1, 0}, {1, 1, 0}}}, "b is 0");
}

}  // namespace
}  // namespace emulsion
