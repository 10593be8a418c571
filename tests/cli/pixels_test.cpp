// --pixels of `emulsion render` and `emulsion merge`: half or float in the EXR.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "film/exr_info.h"
#include "film_states.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class PixelsOption : public ::testing::Test {
  protected:
    PixelsOption() {
        write_text(scene_, kSmallScene);
        write_film_state(state_, film_state(small_film(), 0, 3));
    }

    static ProgramResult run(std::vector<std::string> arguments, const std::vector<std::string>& more) {
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments);
    }
    [[nodiscard]] ProgramResult render(const std::vector<std::string>& more) const {
        return run({"render", scene_, "--spp", "1", "-o", exr_}, more);
    }
    [[nodiscard]] ProgramResult merge(const std::vector<std::string>& more) const {
        return run({"merge", state_, "-o", exr_}, more);
    }
    static std::string type_of_y(const std::string& file) {
        const ExrInfo info = read_exr_info(file);
        for (const ExrChannelInfo& channel : info.parts.front().channels) {
            if (channel.name == "Y") return channel.type;
        }
        return "none";
    }

    TemporaryFolder folder_;
    const std::string scene_ = folder_.file("small.pbrt"), state_ = folder_.file("a.film.exr"),
                      exr_ = folder_.file("a.exr"), png_ = folder_.file("a.png");
};

TEST_F(PixelsOption, SaysWhichNumbersTheFileHas) {
    ASSERT_EQ(merge({}).exit_code, 0);
    EXPECT_EQ(type_of_y(exr_), "float");
    ASSERT_EQ(merge({"--pixels", "half"}).exit_code, 0);
    EXPECT_EQ(type_of_y(exr_), "half");
    EXPECT_THAT(read_exr(exr_).metadata.pixels, IsEmpty()) << "as asked for";
    ASSERT_EQ(render({"--pixels", "float"}).exit_code, 0);
    EXPECT_EQ(type_of_y(exr_), "float");
    ASSERT_EQ(render({"--half"}).exit_code, 0);
    EXPECT_EQ(type_of_y(exr_), "half");
}

// The decision is printed, and stands in the header.
TEST_F(PixelsOption, AutoIsHalfWhereThatWillDo) {
    const ProgramResult result = render({"--pixels", "auto", "--png", png_});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("half: dE00 0.0"));
    EXPECT_THAT(result.out, HasSubstr("within 1 and 3; float would take 2x the bytes, before compression\n"));
    EXPECT_EQ(type_of_y(exr_), "half");
    const std::string reason = read_exr(exr_).metadata.pixels;
    EXPECT_THAT(reason, StartsWith("half: dE00 0.0"));
    EXPECT_THAT(result.out, HasSubstr(reason));
    EXPECT_THAT(run_program({"info", exr_}).out, HasSubstr(reason));

    // The PNG is made of what the file holds.
    const std::string again = folder_.file("again.png");
    ASSERT_EQ(run_program({"develop", exr_, "-o", again}).exit_code, 0);
    EXPECT_TRUE(read_text(again) == read_text(png_));
}

TEST_F(PixelsOption, AutoIsFloatWhereHalfWontDo) {
    const ProgramResult strict = render({"--pixels", "auto:0"});
    ASSERT_EQ(strict.exit_code, 0) << strict.err;
    EXPECT_THAT(strict.out, AllOf(HasSubstr("float: half has dE00 0.0"), HasSubstr("asked for 0 and 0\n")));
    EXPECT_EQ(type_of_y(exr_), "float");
    EXPECT_THAT(read_exr(exr_).metadata.pixels, StartsWith("float: half has dE00 0.0"));
}

TEST_F(PixelsOption, AutoOverflows) {
    std::string bright = kSmallScene;
    const std::string scale = "\"float scale\" 100";
    bright.replace(bright.find(scale), scale.size(), "\"float scale\" 1e6");
    write_text(scene_, bright);
    const ProgramResult result = render({"--pixels", "auto:100"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("float: half would overflow in "));
    EXPECT_THAT(result.err, Not(HasSubstr("too large")));
    EXPECT_EQ(type_of_y(exr_), "float");
}

TEST_F(PixelsOption, AutoSaysNothingIfQuiet) {
    const ProgramResult result = render({"--pixels", "auto", "--quiet"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_EQ(type_of_y(exr_), "half");
}

// Its sums are exact, and most of it: nothing would be won.
TEST_F(PixelsOption, AFilmStateIsFloatUnderAuto) {
    const std::string out = folder_.file("out.film.exr"), plain = folder_.file("plain.film.exr");
    const ProgramResult result = run_program({"merge", state_, "-o", out, "--pixels", "auto"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, StartsWith("float: the exact sums of a film state are most of it\n"));
    EXPECT_EQ(type_of_y(out), "float");
    ASSERT_EQ(run_program({"merge", state_, "-o", plain, "--pixels", "half"}).exit_code, 0);
    EXPECT_EQ(type_of_y(plain), "half");
    EXPECT_TRUE(read_film_state(plain).contents == read_film_state(out).contents) << "of either type";
}

TEST_F(PixelsOption, RefusesWhatIsNone) {
    const std::vector<std::string> before = folder_.names();
    for (const auto& [more, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--pixels", "16"}, "--pixels: found \"16\", expected half, float or auto[:MEAN[,P99]]"},
             {{"--pixels", "auto:x"}, "--pixels: pixels auto: mean = \"x\""},
             {{"--pixels", "auto:-1"}, "--pixels: error budget: mean = -1"},
             {{"--pixels", "half", "--half"}, "--half: found --pixels as well, expected one of the two"},
             {{"--half", "--pixels", "float"}, "--half: found --pixels as well, expected one of the two"}}) {
        for (const ProgramResult& result : {render(more), merge(more)}) {
            EXPECT_EQ(result.exit_code, 2);
            EXPECT_THAT(result.err, HasSubstr(words));
        }
    }
    EXPECT_EQ(folder_.names(), before);
}

}  // namespace
}  // namespace emulsion::testing
