// No output lands on an input or on another output, by whatever names they go.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class DistinctFiles : public ::testing::Test {
  protected:
    DistinctFiles() {
        write_text(folder_.file("small.pbrt"), kSmallScene);
        write_text(folder_.file("scene.exr"), kSmallScene);
    }

    /// In the folder, so that a file has several short names.
    [[nodiscard]] ProgramResult run(const std::vector<std::string>& arguments) const {
        const auto in_folder = [this] {
            if (::chdir(folder_.path().c_str()) != 0) ::_exit(126);
        };
        return run_program(arguments, {.before = in_folder});
    }
    void expect_refused(const std::vector<std::string>& arguments) const {
        const std::vector<std::string> before = folder_.names();
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 2) << ::testing::PrintToString(arguments) << result.err;
        EXPECT_THAT(result.err, StartsWith("emulsion: error: "));
        EXPECT_THAT(result.err, HasSubstr("same file"));
        EXPECT_EQ(folder_.names(), before) << ::testing::PrintToString(arguments);
        EXPECT_EQ(read_text(folder_.file("small.pbrt")), kSmallScene);
        EXPECT_EQ(read_text(folder_.file("scene.exr")), kSmallScene);
    }

    TemporaryFolder folder_;
};

TEST_F(DistinctFiles, ArgumentsThatAreOneFileAreBadUsage) {
    std::filesystem::create_symlink("scene.exr", folder_.path() / "link.exr");
    std::filesystem::create_symlink("not-yet.exr", folder_.path() / "dangling.exr");
    std::filesystem::create_symlink("u.exr", folder_.path() / "u.png");
    std::filesystem::create_symlink("small.pbrt", folder_.path() / "small.png");
    std::filesystem::create_symlink("scene.exr", folder_.path() / "scene.png");
    expect_refused({"render", "small.pbrt", "-o", "u.exr", "--png", "u.png"});
    expect_refused({"render", "small.pbrt", "-o", "u.exr", "--png", "./u.png"});
    expect_refused({"render", "small.pbrt", "-o", folder_.file("u.exr"), "--png", "u.png"});
    std::filesystem::create_symlink("not-yet.exr", folder_.path() / "dangling.png");
    expect_refused({"render", "small.pbrt", "-o", "dangling.exr", "--png", "dangling.png"});
    expect_refused({"render", "small.pbrt", "-o", "u.exr", "--png", "./small.png"});
    expect_refused({"render", "scene.exr", "-o", "scene.exr"});
    expect_refused({"render", "scene.exr", "-o", "link.exr"});
    expect_refused({"develop", "scene.exr", "-o", "scene.png"});
    expect_refused({"develop", "link.exr", "-o", "scene.png"});
}

TEST_F(DistinctFiles, TheScenesOwnNameForTheExrIsMinded) {
    std::filesystem::create_symlink("small.exr", folder_.path() / "small.png");
    expect_refused({"render", "small.pbrt", "--png", "small.png"});
    std::filesystem::create_symlink("small.pbrt", folder_.path() / "small.exr");
    expect_refused({"render", "small.pbrt"});
}

TEST_F(DistinctFiles, OthersAreLeftInPeace) {
    EXPECT_EQ(run({"render", "small.pbrt", "-o", "u.exr", "--png", "u.png"}).exit_code, 0);
    EXPECT_EQ(run({"develop", "u.exr", "-o", "u.png"}).exit_code, 0);
}

}  // namespace
}  // namespace emulsion::testing
