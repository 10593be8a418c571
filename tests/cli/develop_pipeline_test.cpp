// `emulsion develop`: the stages by their flags, and all together as a text.

#include <cstddef>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "develop/pipeline.h"
#include "ramp_picture.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string text_chunk(const std::string& png) {
    const std::string bytes = read_text(png), key = std::string("tEXtPipeline") + '\0';
    const std::size_t at = bytes.find(key);
    if (at == std::string::npos) return "no such text";
    std::size_t length = 0;  // most significant byte first, before the chunk's name
    for (std::size_t i = 4; i > 0; --i) length = length << 8u | static_cast<unsigned char>(bytes[at - i]);
    return bytes.substr(at + key.size(), length - (key.size() - 4));
}

std::string shown(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"develop", "--show-pipeline"});
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
}

std::string refused(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"develop", "none.exr", "-o", "none.png"});
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.out;
    return result.err;
}

TEST(Develop, ShowsThePipelineOfFlagsTextAndFile) {
    const TemporaryFolder folder;
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

TEST(Develop, LeavesAStageToItsOwnAgain) {
    const std::string text =
        shown({"--pipeline", "transfer=pq adaptation=median", "--transfer", "own", "--adaptation", "OWN"});
    EXPECT_EQ(text, to_text(Pipeline{}) + "\n");
    EXPECT_THAT(refused({"--transfer", "owm"}), HasSubstr("--transfer: transfer \"owm\": unknown; expected own"));
    EXPECT_THAT(refused({"--pipeline", "adaptation=owm"}), HasSubstr("expected own"));
}

// Of the ramp, where blue lies far outside of the display, and none where light is grey.
TEST(Develop, ReportsWhatTheDisplayCannotShow) {
    const TemporaryFolder folder;
    FilmPicture picture = ramp();
    const std::string png = folder.file("ramp.png");
    for (XYZ& p : picture.xyz.pixels()) p = {0.9505f * p.y, p.y, 1.089f * p.y};
    const std::string grey = write_picture(folder, picture);
    EXPECT_EQ(run_program({"develop", grey, "-o", png, "--tonemap", "fixed:white=100"}).out, "wrote " + png + "\n");

    for (int x = 0; x < 8; ++x) picture.xyz(x, 3) = {0.0f, 50.0f, 0.0f};
    const std::string green = write_picture(folder, picture);
    const std::vector<std::string> arguments = {"develop", green, "-o", png, "--tonemap", "fixed:white=100"};
    const std::string report = "8 of 1024 pixels (0.78 %) were outside the display's gamut, by up to 0.77 of white; ";
    EXPECT_EQ(run_program(arguments).out, report + "--gamut clip\nwrote " + png + "\n");
    std::vector<std::string> none = arguments, quiet = arguments;
    none.insert(none.end(), {"--gamut", "none"});
    quiet.emplace_back("--quiet");
    EXPECT_EQ(run_program(none).out, report + "--gamut none\nwrote " + png + "\n");
    EXPECT_EQ(run_program(quiet).out, "");
}

TEST(Develop, RefusesFlagsThatNoFileHasAUseFor) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), pfm = folder.file("out.pfm"), csv = folder.file("out.csv");
    const auto err = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"develop", exr});
        const ProgramResult result = run_program(arguments);
        EXPECT_EQ(result.exit_code, 2) << result.out;
        return result.err;
    };
    const std::string no_png = ": found without a PNG to write, expected -o FILE.png or another output that is one";
    EXPECT_THAT(err({"-o", pfm, "--bits", "4"}), HasSubstr("--bits" + no_png));
    EXPECT_THAT(err({"-o", pfm, "--png-level", "9"}), HasSubstr("--png-level" + no_png));
    EXPECT_THAT(err({"--curve", csv, "--display", "hdr10"}), HasSubstr("--display" + no_png));
    EXPECT_THAT(err({"-o", pfm, "--tonemap", "drago"}), HasSubstr("--tonemap: found without a PNG or --curve"));
    EXPECT_THAT(err({"-o", folder.file("out.png"), "--black", "ucr"}), HasSubstr("--black: found alone"));
    EXPECT_FALSE(std::filesystem::exists(pfm));
    EXPECT_EQ(run_program({"develop", exr, "--curve", csv, "--tonemap", "drago"}).exit_code, 0);
    EXPECT_EQ(run_program({"develop", exr, "-o", pfm, "--bloom", "quartic"}).exit_code, 0);
}

TEST(Develop, TakesAMeasuredDisplay) {
    Pipeline expected;
    expected.display = CustomDisplay{.rx = 0.66, .ry = 0.32, .gx = 0.28, .gy = 0.61, .bx = 0.14, .by = 0.05};
    const std::string primaries = "0.66,0.32,0.28,0.61,0.14,0.05";
    EXPECT_EQ(shown({"--primaries", primaries}), to_text(expected) + "\n");
    auto& display = std::get<CustomDisplay>(expected.display);
    display.wx = 0.3, display.wy = 0.32;
    EXPECT_EQ(shown({"--primaries", primaries + ",0.3,0.32"}), to_text(expected) + "\n");
    EXPECT_EQ(shown({"--white", "0.3,0.32", "--primaries", primaries}), to_text(expected) + "\n");
    display.peak_cdm2 = 120.0, display.black_cdm2 = 0.1, display.flare_cdm2 = 2.0;
    EXPECT_EQ(shown({"--primaries", primaries, "--white", "0.3,0.32", "--display",
                     "custom:peak=120,black=0.1,flare=2,rx=0.7,wx=0.31"}),
              to_text(expected) + "\n");
    EXPECT_EQ(shown({"--white", "0.3,0.32", "--pipeline",
                     "display=custom:peak=120,black=0.1,flare=2,rx=0.66,ry=0.32,gx=0.28,gy=0.61,bx=0.14,by=0.05"}),
              to_text(expected) + "\n");
    // The white is that of the primaries of sRGB, where no others are given.
    expected.display = CustomDisplay{.wx = 0.3, .wy = 0.32};
    EXPECT_EQ(shown({"--white", "0.3,0.32"}), to_text(expected) + "\n");
}

// The white may be needed for the primaries to be those of a display: D65 is outside of this triangle.
TEST(Develop, PrimariesAreCheckedWithTheirWhite) {
    const std::string red = "0.7,0.29,0.5,0.45,0.6,0.2";
    EXPECT_THAT(shown({"--primaries", red, "--white", "0.6,0.3"}), HasSubstr("wx=0.6,wy=0.3,"));
    EXPECT_THAT(refused({"--primaries", red}),
                StartsWith("emulsion: error: --primaries: display custom: white (0.3127,"));
    EXPECT_THAT(refused({"--primaries", red, "--white", "0.3,0.3"}),
                StartsWith("emulsion: error: --white: display custom: white (0.3, 0.3): must lie inside"));
    EXPECT_THAT(refused({"--primaries", "0.1,0.1,0.2,0.2,0.3,0.3"}),
                StartsWith("emulsion: error: --primaries: display custom: primaries"));
    EXPECT_THAT(refused({"--display", "custom:rx=0.1"}),
                StartsWith("emulsion: error: --display: display custom: white"));
    EXPECT_THAT(refused({"--scene-white", "bradford:x=0.9,y=0.9"}),
                StartsWith("emulsion: error: --scene-white: scene-white bradford:x=0.9,y=0.9: "));
}

TEST(Develop, FlagsOfAMeasuredDisplaySayWhatTheyDoNotGoWith) {
    const std::string six = "0.64,0.33,0.3,0.6,0.15,0.06";
    const auto expect_refused = [](const std::vector<std::string>& arguments, const std::string& message) {
        EXPECT_EQ(refused(arguments), "emulsion: error: " + message + "\n");
    };
    const std::string beside_other = "found the display srgb as well, expected none, or custom";
    expect_refused({"--primaries", six, "--display", "srgb"}, "--primaries: " + beside_other);
    expect_refused({"--white", "0.3,0.3", "--display", "srgb"}, "--white: " + beside_other);
    expect_refused({"--white", "0.3,0.3", "--pipeline", "display=crt"},
                   "--white: found the display crt as well, expected none, or custom");
    expect_refused({"--primaries", six + ",0.31,0.33", "--white", "0.3,0.3"},
                   "--white: found a white in --primaries as well, expected one of the two");
    for (const char* text : {"0.3", "0.3,0.3,0.4", "0.3,x", "0.3,1.1", "0.3,nan", "bradford:x=0.3,y=0.3", ""}) {
        expect_refused({"--white", text}, std::string("--white: found \"") + text + "\", expected x,y, each in [0, 1]");
    }
    expect_refused({"--primaries", six + ",0.3"},
                   "--primaries: found \"" + six +
                       ",0.3\", expected rx,ry,gx,gy,bx,by or rx,ry,gx,gy,bx,by,wx,wy, each in [0, 1]");
}

TEST(Develop, TakesATableOfTheDisplaysCurve) {
    const TemporaryFolder folder;
    const std::string csv = folder.file("curve.csv");
    write_text(csv, "code,cd/m^2\n0,0.5\n64,20.5\n128,100.5\n");
    Pipeline expected;
    expected.transfer = TableTransfer{{{0.0, 0.0}, {0.5, 0.2}, {1.0, 1.0}}};
    EXPECT_EQ(shown({"--transfer-table", csv}), to_text(expected) + "\n");
    EXPECT_THAT(refused({"--transfer-table", csv, "--transfer", "pq"}),
                StartsWith("emulsion: error: --transfer-table: found --transfer as well, expected one of the two"));
    write_text(csv, "0,1\n1,x\n");
    EXPECT_EQ(refused({"--transfer-table", csv}),
              "emulsion: error: --transfer-table: " + csv + ": line 2: luminance is \"x\", expected a finite number\n");
    EXPECT_THAT(refused({"--transfer-table", folder.file("none")}), HasSubstr("none: No such file or directory"));
}

// All that makes the picture is in the PNG, also what files and flags of their own gave.
TEST(Develop, ThePngHoldsTheMeasuredDisplay) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), png = folder.file("a.png"), again = folder.file("b.png");
    write_text(folder.file("curve.csv"), "0,0\n1,20\n2,100\n");
    const ProgramResult result =
        run_program({"develop", exr, "-o", png, "--primaries", "0.66,0.32,0.28,0.61,0.14,0.05", "--white", "0.3,0.32",
                     "--transfer-table", folder.file("curve.csv"), "--scene-white", "cat16:x=0.45,y=0.41"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string text = text_chunk(png);
    for (const char* part : {"scene-white=cat16:x=0.45,y=0.41", "display=custom:rx=0.66,", "wx=0.3,wy=0.32,",
                             "transfer=table:0=0,0.5=0.2,1=1"}) {
        EXPECT_THAT(text, HasSubstr(part));
    }
    ASSERT_EQ(run_program({"develop", exr, "-o", again, "--pipeline", text}).exit_code, 0);
    EXPECT_EQ(read_text(again), read_text(png));
}

}  // namespace
}  // namespace emulsion::testing
