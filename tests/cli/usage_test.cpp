// What the program says of command lines that it can't take, and its help.

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/help_formatter.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using Words = std::vector<std::string>;

void expect_refused(const Words& arguments, const std::string& message) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << ::testing::PrintToString(arguments);
    EXPECT_EQ(result.err, "emulsion: error: " + message + "\n");
    EXPECT_EQ(result.out, "");
}

TEST(Usage, NamesTheOptionWhatWasFoundAndWhatWasExpected) {
    expect_refused({"render", "x", "--spp", "abc"}, "--spp: found \"abc\", expected a whole number from 1 to 16777216");
    expect_refused({"render", "x", "--spp", "0"}, "--spp: found \"0\", expected a whole number from 1 to 16777216");
    expect_refused({"render", "x", "--threads", "2000"},
                   "--threads: found \"2000\", expected a whole number from 0 to 1024");
    expect_refused({"render", "x", "--spp", "010"}, "--spp: found \"010\", expected a whole number from 1 to 16777216");
    expect_refused({"info", "x", "--threads", "-1"}, "--threads: found \"-1\", expected a whole number from 0 to 1024");
    expect_refused({"render", "x", "--model", "spectral:3"},
                   "--model: transport model spectral: wavelengths 3: must be one of 1, 2, 4, 8, 16, 32");
    expect_refused({"render", "x", "--seed", "-1"},
                   "--seed: found \"-1\", expected a whole number from 0 to 18446744073709551615");
    expect_refused({"render", "x", "--checkpoint", "0"},
                   "--checkpoint: found \"0\", expected a number of seconds above 0");
    expect_refused({"render", "x", "--space", "sRGB", "--rgb"},
                   "--rgb: found --space as well, expected one of the two");
    expect_refused({"render", "x", "--rgb", "--space", "sRGB"},
                   "--rgb: found --space as well, expected one of the two");
    const ProgramResult section = run_program({"color", "list", "nothing"});
    EXPECT_EQ(section.exit_code, 2);
    EXPECT_THAT(section.err, HasSubstr("SECTION: found \"nothing\", expected one of spaces, rgb-spaces, "));
}

TEST(Usage, SaysWhatIsMissingOrTooMuch) {
    expect_refused({}, "found no subcommand, expected render, develop, merge, info, compare, analyze, chart or color");
    expect_refused(
        {"paint", "x"},
        "found the subcommand \"paint\", expected render, develop, merge, info, compare, analyze, chart or color");
    expect_refused(
        {"color", "paint"},
        "found the subcommand \"paint\", expected convert, spectrum, difference, adapt, encode, decode, matrix "
        "or list");
    expect_refused({"render"}, "SCENE: found none, expected one");
    expect_refused({"merge", "a.film.exr"}, "--output: found none, expected FILE");
    expect_refused({"color", "matrix", "--from", "XYZ"}, "--to: found none, expected SPACE");
    expect_refused({"render", "x", "--crop"}, "--crop: found no value, expected X0,Y0,X1,Y1");
    expect_refused({"develop"}, "PICTURE: found none, expected a file");
    expect_refused({"develop", "a.exr"},
                   "--output: found none, expected it, --contact-sheet, --exposures, --plates, --print-preview or "
                   "--curve");
    expect_refused({"render", "x", "--spp", "1", "--spp", "2"}, "--spp: found 2 values, expected one");
    expect_refused({"info", "a", "b"}, "found \"b\", expected no further argument of emulsion info");
    expect_refused({"render", "x", "--tonemaps=y"},
                   "found \"--tonemaps=y\", expected an option of emulsion render; nearest: --tonemap");
}

// Neither those that set a bool nor those that call back, of whatever command; no value says "no", either.
TEST(Usage, AFlagTakesNoValue) {
    for (const char* value : {"yes", "no", "maybe", "0", "2", "false"}) {
        expect_refused({"render", "x", std::string("--half=") + value}, "--half: found a value, expected none");
    }
    expect_refused({"render", "x", "--splat=no"}, "--splat: found a value, expected none");
    expect_refused({"merge", "x", "-o", "a.exr", "--rgb=yes"}, "--rgb: found a value, expected none");
    expect_refused({"color", "spectrum", "--json=on"}, "--json: found a value, expected none");
}

TEST(Usage, APictureHasTheNameOfItsKind) {
    expect_refused({"render", "x", "--png", "y.exr"}, "--png: found \"y.exr\", expected a name ending in .png");
    expect_refused({"merge", "x", "-o", "a.exr", "--png", "y"}, "--png: found \"y\", expected a name ending in .png");
    expect_refused({"develop", "x", "-o", "o.exr"},
                   "--output: found \"o.exr\", expected a name ending in .png, .pfm or .hdr");
    expect_refused({"render", "x", "-o", "o.png"},
                   "--output: found \"o.png\", expected a name ending in .exr (--png writes a PNG)");
}

// Found only when the scene was read, and bad usage all the same.
TEST(Usage, WhatOnlyTheSceneCanTell) {
    const TemporaryFolder folder;
    const std::string scene = folder.file("small.pbrt"), exr = folder.file("a.exr");
    write_text(scene, kSmallScene);
    expect_refused({"render", scene, "-o", exr, "--crop", "0,0,49,4"},
                   "--crop: found \"0,0,49,4\", expected pixels inside the frame of 48x32");
    expect_refused({"render", scene, "-o", exr, "--resolution", "8x8", "--crop", "0,0,8,9"},
                   "--crop: found \"0,0,8,9\", expected pixels inside the frame of 8x8");
    expect_refused(
        {"render", scene, "-o", exr, "--firefly", "clamp:luminance=2e30"},
        "--firefly: film: firefly control clamp: luminance is 2e+30 cd/m^2, which times the imaging ratio 1 is "
        "2e+30, expected a product in [1e-30, 1e+30]");
    EXPECT_THAT(folder.names(), ::testing::ElementsAre("small.pbrt"));
    const ProgramResult largest = run_program({"render", scene, "-o", exr, "--firefly", "clamp:luminance=1e30"});
    EXPECT_EQ(largest.exit_code, 0) << largest.err;
}

TEST(Usage, AMissingFileIsSaidInOneWay) {
    for (const Words& arguments : std::vector<Words>{{"info", "none"},
                                                     {"render", "none"},
                                                     {"develop", "none", "-o", "a.png"},
                                                     {"merge", "none", "-o", "a.exr"},
                                                     {"color", "convert", "--from", "XYZ", "--to", "sRGB", "none"}}) {
        EXPECT_EQ(run_program(arguments).err, "emulsion: error: none: No such file or directory\n");
    }
    EXPECT_THAT(run_program({"color", "spectrum", "none"}).err, HasSubstr("none: No such file or directory, and "));
}

TEST(Help, FitsOnATerminal) {
    for (const char* command :
         {"", "render", "develop", "merge", "info", "color", "color convert", "color spectrum", "color difference",
          "color adapt", "color encode", "color decode", "color matrix", "color list"}) {
        std::istringstream words(command);
        Words arguments;
        for (std::string word; words >> word;) arguments.push_back(word);
        arguments.emplace_back("--help");
        std::istringstream help(run_program(arguments).out);
        int lines = 0;
        for (std::string line; std::getline(help, line); ++lines) {
            EXPECT_LE(line.size(), 100u) << command << ": " << line;
            EXPECT_FALSE(line.ends_with(' ')) << command << ": " << line;
        }
        EXPECT_GT(lines, 5) << command;
    }
    EXPECT_THAT(run_program({"render", "--help"}).out, Not(HasSubstr("Excludes")));
}

// But with its default, wherever it is another's, too.
TEST(Help, SaysOnceWhatAParameterMeans) {
    const std::string help = run_program({"develop", "--help"}).out;
    const auto count = [&](const std::string& words) {
        int found = 0;
        for (std::size_t at = help.find(words); at != std::string::npos; at = help.find(words, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count("luminance of black in a dark room"), 1);
    EXPECT_EQ(count("luminance of white, cd/m^2, in [10, 10000]"), 1);
    EXPECT_EQ(count("luminance of white, cd/m^2, in [400, 2000]"), 1);
    EXPECT_EQ(count("peak=48, black=0, flare=0  as above"), 1);
    EXPECT_EQ(count("black=0, flare=0  as above"), 8);
}

TEST(Help, IsBrokenBetweenWords) {
    EXPECT_EQ(cli::wrapped("one two three\n\nfour", 7, 4), "one two\nthree\n\nfour");
    EXPECT_EQ(cli::wrapped("  -o  one two three", 11, 6), "  -o  one\n      two\n      three");
    EXPECT_EQ(cli::wrapped("        one two three", 16, 6), "        one two\n          three");
    EXPECT_EQ(cli::wrapped("a longword, in (0, inf)", 18, 4), "a longword, in\n(0, inf)");
    EXPECT_EQ(cli::wrapped("  -o  unbreakable", 8, 6), "  -o  unbreakable");
    EXPECT_EQ(cli::wrapped("unbreakable it is", 4, 2), "unbreakable\nit\nis");
}

}  // namespace
}  // namespace emulsion::testing
