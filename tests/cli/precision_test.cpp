// --precision of `emulsion develop`, and precision= of its text.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ramp_picture.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// A ramp with an edge, at which local adaptations of the two ways differ.
class PrecisionOption : public ::testing::Test {
  protected:
    PrecisionOption() {
        FilmPicture picture = ramp();
        for (int y = 4; y < 12; ++y) {
            for (int x = 20; x < 30; ++x) picture.xyz(x, y) = {3000.0f, 3000.0f, 2000.0f};
        }
        exr_ = write_picture(folder_, picture);
    }

    [[nodiscard]] ProgramResult develop(const std::string& png, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"develop", exr_, "-o", png, "--bits", "16", "--tonemap", "high-contrast"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments);
    }

    TemporaryFolder folder_;
    std::string exr_;
    const std::string png_ = folder_.file("a.png"), again_ = folder_.file("b.png");
};

TEST_F(PrecisionOption, ChoosesTheWay) {
    ASSERT_EQ(develop(png_, {}).exit_code, 0);
    const std::string fast = read_text(png_);
    EXPECT_THAT(fast, HasSubstr("adaptation=own precision=fast "));
    ASSERT_EQ(develop(png_, {"--precision", "fast"}).exit_code, 0);
    EXPECT_TRUE(read_text(png_) == fast);
    ASSERT_EQ(develop(png_, {"--precision", "reference"}).exit_code, 0);
    const std::string exact = read_text(png_);
    EXPECT_THAT(exact, HasSubstr("precision=reference "));
    EXPECT_FALSE(exact == fast);

    // By its own text, to the byte; the flag goes before a text.
    ASSERT_EQ(develop(again_, {"--pipeline", "precision=reference"}).exit_code, 0);
    EXPECT_TRUE(read_text(again_) == exact);
    ASSERT_EQ(develop(again_, {"--precision", "fast", "--pipeline", "precision=reference"}).exit_code, 0);
    EXPECT_TRUE(read_text(again_) == fast);
}

TEST_F(PrecisionOption, AutoSaysWhatItFoundAndThePngHasIt) {
    const ProgramResult fast = develop(png_, {"--precision", "auto"});
    ASSERT_EQ(fast.exit_code, 0) << fast.err;
    EXPECT_THAT(fast.out, ContainsRegex("^fast: dE00 [^ ]+ mean, [^ ]+ p99 on 64x16 pixels, within 1 and 3; found in "
                                        "[^ ]+ s\n"));
    EXPECT_THAT(read_text(png_), AllOf(HasSubstr("precision=fast "), Not(HasSubstr("auto"))));

    const ProgramResult exact = develop(png_, {"--precision", "auto:0"});
    ASSERT_EQ(exact.exit_code, 0) << exact.err;
    EXPECT_THAT(exact.out, ContainsRegex("^reference: fast has dE00 [^ ]+ mean, [^ ]+ p99 on 64x16 pixels; asked for 0 "
                                         "and 0; found in [^ ]+ s\n"));
    EXPECT_THAT(read_text(png_), HasSubstr("precision=reference "));
    ASSERT_EQ(develop(again_, {"--precision", "reference"}).exit_code, 0);
    EXPECT_TRUE(read_text(again_) == read_text(png_));

    EXPECT_THAT(develop(png_, {"--precision", "auto", "--quiet"}).out, IsEmpty());
}

TEST_F(PrecisionOption, RefusesWhatIsNone) {
    for (const auto& [more, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--precision", "exact"}, "--precision: found \"exact\", expected fast, reference or auto[:MEAN[,P99]]"},
             {{"--precision", "auto:-1"}, "--precision: error budget: mean = -1"},
             {{"--pipeline", "precision=auto"}, "precision \"auto\": unknown; expected fast"},
             {{"--precision", "auto", "--show-pipeline"},
              "--precision: found auto without a PNG to write, expected fast or reference"}}) {
        const ProgramResult result = develop(png_, more);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err, AllOf(StartsWith("emulsion: error: "), HasSubstr(words)));
    }
    const ProgramResult unseen = run_program({"develop", exr_, "-o", folder_.file("a.pfm"), "--precision", "auto"});
    EXPECT_EQ(unseen.exit_code, 2);
    EXPECT_THAT(unseen.err, HasSubstr("found auto without a PNG to write"));
}

}  // namespace
}  // namespace emulsion::testing
