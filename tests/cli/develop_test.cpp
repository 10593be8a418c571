// `emulsion develop`: what helps to choose an operator.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"
#include "develop/pipeline.h"
#include "film/exr_file.h"
#include "film/pfm_file.h"
#include "film/radiance_file.h"
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

/// Luminances 1 to 64 cd/m^2 from left to right.
FilmPicture ramp() {
    FilmPicture picture;
    picture.xyz = Image<XYZ>(64, 16);
    picture.data_window = {0, 0, 64, 16};
    picture.width_px = 64;
    picture.height_px = 16;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 64; ++x)
            picture.xyz(x, y) = {1.0f + static_cast<float>(x), 1.0f + static_cast<float>(x), 9.0f};
    }
    return picture;
}

std::string write_picture(const TemporaryFolder& folder, const FilmPicture& picture) {
    const std::string exr = folder.file("ramp.exr");
    (void)write_exr(exr, picture, {}, {});
    return exr;
}

std::string write_ramp(const TemporaryFolder& folder) { return write_picture(folder, ramp()); }

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
    const std::string own = read_text(strip);
    EXPECT_THAT(own, StartsWith("\x89PNG"));
    EXPECT_EQ(run_program({"develop", exr, "--exposures", strip, "--tonemap", "fixed:white=6.4"}).exit_code, 0);
    EXPECT_EQ(read_text(strip), own);
    EXPECT_EQ(run_program({"develop", exr, "--exposures", strip, "--tonemap", "fixed:white=32"}).exit_code, 0);
    EXPECT_NE(read_text(strip), own);
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
    EXPECT_NE(read_text(own), read_text(dark));
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
        return std::pair(result.out, read_text(strip));
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

// The picture's own XYZ: Y from 1 to 64 cd/m^2, colours outside Rec. 709 among them.
TEST(Develop, WritesTheScenesOwnLightByTheNamesEnding) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), pfm = folder.file("a.pfm"), hdr = folder.file("a.HDR");
    ProgramResult result = run_program({"develop", exr, "-o", pfm, "--tonemap", "max-to-white"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out, "wrote " + pfm + "\n");
    const Image<XYZ> read = read_pfm(pfm).xyz;
    for (int x = 0; x < 64; ++x) EXPECT_NEAR(read(x, 3).y, 1.0f + static_cast<float>(x), 1e-4);
    result = run_program({"develop", exr, "-o", hdr});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("components below 0 (colours outside Rec. 709) are stored as 0"));
    EXPECT_EQ(read_radiance(hdr).xyz.width(), 64);
    // With bloom, which comes before tone mapping, the light is another.
    EXPECT_EQ(run_program({"develop", exr, "-o", pfm, "--bloom", "quartic"}).exit_code, 0);
    EXPECT_GT(std::abs(read_pfm(pfm).xyz(63, 3).y - read(63, 3).y), 0.01);
}

TEST(Develop, ReadsPicturesOfOthersByTheirContents) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), pfm = folder.file("a.pfm"), png = folder.file("a.png");
    ASSERT_EQ(run_program({"develop", exr, "-o", pfm}).exit_code, 0);
    std::filesystem::rename(pfm, folder.file("picture.exr"));
    ProgramResult result = run_program({"develop", folder.file("picture.exr"), "-o", png});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("picture.exr: no primaries: taken as Rec. 709"));
    result = run_program({"develop", png, "-o", folder.file("again.png")});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("its white is taken as 1 cd/m^2"));
    write_text(folder.file("text"), "no picture");
    result = run_program({"develop", folder.file("text"), "-o", png});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err,
                HasSubstr("begins with \"no p\": expected an OpenEXR, Radiance (#?), PFM (PF or Pf) or PNG"));
}

std::string text_chunk(const std::string& png) {
    const std::string bytes = read_text(png), key = std::string("tEXtPipeline") + '\0';
    const std::size_t at = bytes.find(key);
    if (at == std::string::npos) return "no such text";
    std::size_t length = 0;  // most significant byte first, before the chunk's name
    for (std::size_t i = 4; i > 0; --i) length = length << 8u | static_cast<unsigned char>(bytes[at - i]);
    return bytes.substr(at + key.size(), length - (key.size() - 4));
}

TEST(Develop, ShowsThePipelineOfFlagsTextAndFile) {
    const TemporaryFolder folder;
    const auto shown = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"develop", "--show-pipeline"});
        const ProgramResult result = run_program(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result.out;
    };
    EXPECT_EQ(shown({}), to_text(Pipeline{}) + "\n");
    Pipeline expected;
    expected.tone_mapper = FixedWhite{.white = 32.0f};
    expected.bits = 10;
    expected.range = NarrowRange{};
    expected.dither = NoDither{};
    expected.transfer = PqTransfer{};
    const std::string text = to_text(expected);
    EXPECT_EQ(shown({"--tonemap", "fixed:white=32", "--display", "srgb", "--gamut", "clip", "--transfer", "pq",
                     "--bits", "10", "--range", "narrow", "--dither", "none"}),
              text + "\n");
    EXPECT_EQ(shown({"--pipeline", text}), text + "\n");
    write_text(folder.file("pipeline"), "tonemap=fixed:white=32\n transfer=pq\n bits=10 range=narrow dither=none\n");
    EXPECT_EQ(shown({"--pipeline", folder.file("pipeline")}), text + "\n");
    // Flags of single stages go before, wherever they stand.
    expected.bits = 12;
    EXPECT_EQ(shown({"--bits", "12", "--pipeline", text}), to_text(expected) + "\n");
    EXPECT_EQ(shown({"--pipeline", text, "--bits", "12"}), to_text(expected) + "\n");
}

TEST(Develop, ThePipelineInThePngMakesTheSamePicture) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), png = folder.file("a.png"), again = folder.file("b.png");
    ASSERT_EQ(
        run_program({"develop", exr, "-o", png, "--tonemap", "drago", "--transfer", "bt709", "--bits", "5"}).exit_code,
        0);
    const std::string text = text_chunk(png);
    EXPECT_EQ(parse_pipeline(text).bits, 5);
    EXPECT_EQ(to_text(parse_pipeline(text)), text);
    ASSERT_EQ(run_program({"develop", exr, "-o", again, "--pipeline", text}).exit_code, 0);
    EXPECT_EQ(read_text(again), read_text(png));
    // Its transfer function is in the file.
    EXPECT_THAT(read_text(png), HasSubstr("iCCP"));
    // The sheet has it, too.
    ASSERT_EQ(run_program({"develop", exr, "--contact-sheet", again, "--pipeline", text}).exit_code, 0);
    EXPECT_THAT(read_text(again), HasSubstr("iCCP"));
}

TEST(Develop, WrongStagesAreRefusedBeforeTheWork) {
    const auto refused = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"develop", "none.exr", "-o", "none.png"});
        const ProgramResult result = run_program(arguments);
        EXPECT_EQ(result.exit_code, 2) << result.out;
        return result.err;
    };
    EXPECT_THAT(refused({"--transfer", "gama"}), HasSubstr("transfer \"gama\": unknown; expected gamma, "));
    EXPECT_THAT(refused({"--dither", "nine"}), HasSubstr("dither \"nine\": unknown; expected none"));
    EXPECT_THAT(refused({"--gamut", "x"}), HasSubstr("gamut \"x\": unknown; expected clip"));
    EXPECT_THAT(refused({"--display", "x"}), HasSubstr("display \"x\": unknown; expected"));
    EXPECT_THAT(refused({"--range", "x"}), HasSubstr("range \"x\": unknown; expected"));
    EXPECT_THAT(refused({"--bits", "17"}), HasSubstr("--bits: found \"17\", expected a whole number from 1 to 16"));
    EXPECT_THAT(refused({"--range", "narrow", "--bits", "7"}), HasSubstr("bits of the narrow range = 7"));
    EXPECT_THAT(refused({"--range", "narrow", "--transfer", "bt1886"}), HasSubstr("range narrow"));
    EXPECT_THAT(refused({"--pipeline", "tonmap=drago"}),
                HasSubstr("pipeline stage \"tonmap\": unknown; expected tonemap"));
    EXPECT_THAT(refused({"--pipeline", "no-such-file"}), HasSubstr("--pipeline: no-such-file: No such file"));
}

TEST(Develop, PacksThePngAsAsked) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder);
    const auto size_at = [&](const std::string& level) {
        EXPECT_EQ(run_program({"develop", exr, "-o", folder.file("a.png"), "--png-level", level}).exit_code, 0);
        return std::filesystem::file_size(folder.file("a.png"));
    };
    EXPECT_GT(size_at("0"), size_at("2"));
    const ProgramResult refused = run_program({"develop", exr, "-o", folder.file("a.png"), "--png-level", "10"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("--png-level: found \"10\", expected a whole number from 0 to 9"));
}

}  // namespace
}  // namespace emulsion::testing
