// `emulsion develop`: what helps to choose an operator.

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"
#include "ramp_picture.h"
#include "run_program.h"
#include "support/temporary_folder.h"
#include "tonemap/bloom.h"
#include "tonemap/tone_mapper.h"

namespace emulsion::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The PNG's compressed pixels, without the pipeline's text before them.
std::string pixels_of(const std::string& png) {
    const std::string bytes = read_text(png);
    EXPECT_THAT(bytes, StartsWith("\x89PNG"));
    return bytes.substr(std::min(bytes.find("IDAT"), bytes.size()));
}

// Names at the start of a line, everything else indented.
TEST(Develop, ListsEveryOperatorAndAdaptation) {
    const auto expect_blocks = [](const std::string& flag, const std::vector<std::string_view>& names) {
        const ProgramResult result = run_program({"develop", flag});
        EXPECT_EQ(result.exit_code, 0);
        std::vector<std::string> found;
        for (const std::string& line : lines_of(result.out)) {
            if (!line.empty() && line[0] != ' ') found.push_back(line);
        }
        EXPECT_EQ(found, std::vector<std::string>(names.begin(), names.end()));
    };
    expect_blocks("--list-tonemaps", names_of<ToneMapper>());
    expect_blocks("--list-adaptations", names_of<Adaptation>());
    EXPECT_THAT(run_program({"develop", "--list-tonemaps"}).out,
                HasSubstr("\nfixed\n    linear, a given luminance becomes display white\n    adapted to: log-average\n"
                          "    white  [default: 100; range: (0, inf); unit: cd/m^2]\n"));
}

TEST(Develop, ListsAnOperatorsOwnAdaptationAndSaysWhereThereIsNoUnit) {
    const std::string list = run_program({"develop", "--list-tonemaps"}).out;
    for_each_alternative<ToneMapper>([&](const auto& mapper) {
        EXPECT_THAT(
            list, HasSubstr(std::string(mapper.kHelp) + "\n    adapted to: " + to_text(own_adaptation(mapper)) + '\n'));
    });
    EXPECT_THAT(list, HasSubstr("\n    key  [default: 0.18; range: auto or (0, inf); unit: none]\n"));
    EXPECT_THAT(list, HasSubstr("\n    white  [default: inf; range: auto, max or (0, inf]; unit: none]\n"));
    EXPECT_THAT(run_program({"develop", "--list-adaptations"}).out,
                HasSubstr("\n    contrast  [default: 0.5; range: (0, 10]; unit: none]\n"));
}

TEST(Develop, WritesTheCurve) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), csv = folder.file("curve.csv");
    const ProgramResult result = run_program({"develop", exr, "--curve", csv, "--tonemap", "fixed:white=32"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::vector<std::string> lines = lines_of(read_text(csv));
    ASSERT_GE(lines.size(), 4u);
    EXPECT_THAT(lines[0], StartsWith("# fixed:white=32,scale=1 adapted to log-average"));
    EXPECT_EQ(lines[2], "luminance_cdm2,display_luminance");
    EXPECT_EQ(lines[3], "1,0.03125");
    EXPECT_EQ(lines.back(), "64,2");
}

TEST(Develop, CurveOfALocalOperatorSaysWhatItHoldsFor) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), csv = folder.file("curve.csv");
    EXPECT_EQ(run_program({"develop", exr, "--curve", csv, "--tonemap", "durand"}).exit_code, 0);
    const std::vector<std::string> lines = lines_of(read_text(csv));
    ASSERT_GE(lines.size(), 5u);
    EXPECT_THAT(lines[0], StartsWith("# durand:contrast=50 adapted to bilateral"));
    EXPECT_THAT(lines[2], StartsWith("# holds for large areas of a luminance"));
    EXPECT_EQ(lines[3], "luminance_cdm2,display_luminance");
}

TEST(Develop, DrawsTheContactSheetBesideThePicture) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder);
    const ProgramResult result =
        run_program({"develop", exr, "--contact-sheet", folder.file("sheet.png"), "-o", folder.file("ramp.png")});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(read_text(folder.file("sheet.png")), StartsWith("\x89PNG"));
    EXPECT_THAT(read_text(folder.file("ramp.png")), HasSubstr("tonemap=reinhard-global:key=0.18,white=inf"));
}

// Luminances 1 to 64 cd/m^2, 6 zones; a tenth of the brightest is 6.4.
TEST(Develop, DrawsThreeExposures) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), strip = folder.file("strip.png");
    EXPECT_EQ(run_program({"develop", exr, "--exposures", strip}).exit_code, 0);
    const std::string own = pixels_of(strip);
    EXPECT_EQ(run_program({"develop", exr, "--exposures", strip, "--tonemap", "fixed:white=6.4"}).exit_code, 0);
    EXPECT_EQ(pixels_of(strip), own);
    EXPECT_EQ(run_program({"develop", exr, "--exposures", strip, "--tonemap", "fixed:white=32"}).exit_code, 0);
    EXPECT_NE(pixels_of(strip), own);
}

// Once, whatever is written.
TEST(Develop, ReportsBadPixelsWithEveryOutput) {
    const TemporaryFolder folder;
    FilmPicture picture = ramp();
    picture.xyz(5, 3).y = std::numeric_limits<float>::quiet_NaN();
    picture.xyz(2, 9).y = -1.0f;
    const std::string exr = write_picture(folder, picture);
    const std::vector<std::vector<std::string>> outputs = {{"-o", folder.file("ramp.png")},
                                                           {"--contact-sheet", folder.file("sheet.png")},
                                                           {"--exposures", folder.file("strip.png")},
                                                           {"--curve", folder.file("curve.csv")}};
    std::vector<std::string> all = {"develop", exr, "--bloom", "quartic"};
    const auto expect_one_report = [](const std::vector<std::string>& arguments) {
        const ProgramResult result = run_program(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err,
                  "emulsion: warning: 2 of 1024 pixels are bad (1 NaN, 0 infinite, 1 of negative luminance), the first "
                  "at 5, 3\n");
    };
    for (const std::vector<std::string>& output : outputs) {
        expect_one_report({"develop", exr, output[0], output[1]});
        all.insert(all.end(), output.begin(), output.end());
    }
    expect_one_report(all);
}

TEST(Develop, ContactSheetIsUnderTheAdaptationThatIsGiven) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), own = folder.file("own.png"), dark = folder.file("dark.png");
    EXPECT_EQ(run_program({"develop", exr, "--contact-sheet", own}).exit_code, 0);
    EXPECT_EQ(run_program({"develop", exr, "--contact-sheet", dark, "--adaptation", "spot:x=0"}).exit_code, 0);
    EXPECT_NE(pixels_of(own), pixels_of(dark));
}

// Exposures and zones are those of a picture that has bloomed before.
TEST(Develop, MeasuresThePictureAfterBloom) {
    const TemporaryFolder folder;
    FilmPicture picture = ramp();
    for (XYZ& pixel : picture.xyz.pixels()) pixel = {1.0f, 1.0f, 1.0f};
    for (const int x : {16, 32, 48}) picture.xyz(x, 8) = {1024.0f, 1024.0f, 1024.0f};
    const std::string strip = folder.file("strip.png");
    const auto measured = [&](const std::string& bloom) {
        const std::string exr = write_picture(folder, picture);
        const ProgramResult result =
            run_program({"develop", exr, "--exposures", strip, "--tonemap", "zone", "--bloom", bloom});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.out, StartsWith("the picture spans "));
        return std::pair(result.out, pixels_of(strip));
    };
    const auto plain = measured("none");
    const auto bloomed = measured("quartic:weight=0.9");
    picture.xyz = add_bloom(QuarticBloom{.weight = 0.9f}, picture.xyz.view(), 0);
    const auto bloomed_before = measured("none");
    EXPECT_EQ(bloomed, bloomed_before);
    EXPECT_NE(bloomed.first, plain.first);
    EXPECT_NE(bloomed.second, plain.second);
}

TEST(Develop, SaysHowManyZonesThePictureSpans) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run_program({"develop", write_ramp(folder), "-o", folder.file("ramp.png"), "--tonemap", "zone"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("the picture spans 6.0 zones\n"));
}

}  // namespace
}  // namespace emulsion::testing
