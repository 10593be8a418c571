// `emulsion develop`: previews of a print.

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "display/png_read.h"
#include "ramp_picture.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

TEST(DevelopPrint, WritesPlatesAndTheirComposite) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), plates = folder.file("plates.png"), print = folder.file("print.png"),
                      png = folder.file("a.png");
    const ProgramResult result =
        run_program({"develop", exr, "-o", png, "--plates", plates, "--print-preview", print, "--bits", "16",
                     "--dither", "none", "--black", "ucr:start=0.25", "--bloom", "quartic"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, EndsWith("\nwrote " + png + "\nwrote " + plates + "\nwrote " + print + "\n"));
    for (const std::string& file : {plates, print}) {
        EXPECT_THAT(read_text(file), HasSubstr("bloom=quartic"));
        EXPECT_THAT(read_text(file), HasSubstr(std::string("Black ink") + '\0' + "ucr:amount=1,start=0.25"));
    }
    // Within 2 codes of 65535, encoded; of sRGB's light, whose slope is at most 2.3, and so of Y.
    const Image<XYZ> developed = read_png(png).xyz, printed = read_png(print).xyz;
    ASSERT_EQ(printed.width(), 64);
    for (int x = 0; x < 64; ++x) EXPECT_NEAR(printed(x, 5).y, developed(x, 5).y, 2 * 2.3 / 65535) << x;
    EXPECT_GT(read_png(plates).xyz.width(), 2 * 64);
}

TEST(DevelopPrint, BlackInkIsAsAsked) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), png = folder.file("a.png");
    const auto plates_of = [&](const std::string& black) {
        EXPECT_EQ(run_program({"develop", exr, "--plates", png, "--black", black, "--bits", "1"}).exit_code, 0);
        return read_png(png).xyz;
    };
    EXPECT_NE(plates_of("none"), plates_of("gcr"));
    EXPECT_NE(plates_of("gcr:amount=0.5"), plates_of("gcr"));
}

TEST(DevelopPrint, WhatCannotBeIsSaid) {
    const auto refused = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"develop", "none.exr"});
        const ProgramResult result = run_program(arguments);
        EXPECT_EQ(result.exit_code, 2) << result.out;
        return result.err;
    };
    EXPECT_THAT(refused({"--plates", "a.exr"}), HasSubstr("--plates: found \"a.exr\", expected a name ending in .png"));
    EXPECT_THAT(refused({"--print-preview", "a"}), HasSubstr("--print-preview: found \"a\", expected a name ending"));
    EXPECT_THAT(refused({"--plates", "a.png", "--black", "gcl"}),
                HasSubstr("--black: black \"gcl\": unknown; expected gcr, "));
    EXPECT_THAT(refused({"--plates", "a.png", "--black", "ucr:start=1"}),
                HasSubstr("--black: black ucr: start = 1: must be in [0, 1)"));
    EXPECT_THAT(refused({"--plates", "a.png", "--print-preview", "./a.png"}), HasSubstr("which is the same file as"));
    EXPECT_THAT(refused({"--plates", "a.png", "--range", "narrow", "--transfer", "bt1886"}), HasSubstr("range narrow"));
}

}  // namespace
}  // namespace emulsion::testing
