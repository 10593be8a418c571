// `emulsion analyze` and `render --model auto`: what transport models would get wrong in a scene.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "json_check.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kGlass = EMULSION_SOURCE_DIR "/tests/data/scenes/sodium-glass.pbrt";

TEST(AnalyzeProgram, ShowsNoErrorOfModelsThatSeeNoDispersion) {
    const ProgramResult text = run_program({"analyze", kGlass});
    EXPECT_EQ(text.exit_code, 0) << text.err;
    EXPECT_THAT(text.out, AllOf(ContainsRegex("rgb:sRGB +- +- "), ContainsRegex("basis:8 +- +- "),
                                ContainsRegex("\\* spectral:[0-9]+:hero-illuminant +0.00 +0.00 "),
                                HasSubstr("% of the light, which models of channels don't see\n")));
    EXPECT_THAT(text.out, Not(HasSubstr("e-")));

    const ProgramResult json = run_program({"analyze", kGlass, "--json"});
    EXPECT_TRUE(JsonCheck::is_json(json.out)) << json.out;
    EXPECT_THAT(json.out, HasSubstr(R"({"model": "rgb:sRGB", "mean": null, "p99": null, )"));
    EXPECT_THAT(json.out, HasSubstr(R"({"model": "spectral:1", "mean": 0, "p99": 0, )"));
}

/// One line, the model first.
TEST(AnalyzeProgram, TheDecisionStandsInTheHeader) {
    const TemporaryFolder folder;
    const std::string scene = folder.file("small.pbrt"), exr = folder.file("small.exr");
    write_text(scene, kSmallScene);
    const ProgramResult rendered = run_program({"render", scene, "--model", "auto:5", "-o", exr});
    EXPECT_EQ(rendered.exit_code, 0) << rendered.err;
    EXPECT_THAT(rendered.out, HasSubstr("rgb:sRGB: predicted dE00 "));
    EXPECT_THAT(run_program({"info", exr}).out,
                ContainsRegex("model +rgb:sRGB: predicted dE00 [0-9.]+ mean, [0-9.]+ p99; asked for 5 mean, 15 p99; "
                              "spectral:4 would cost 1.[0-9]+x\n"));
}

}  // namespace
}  // namespace emulsion::testing
