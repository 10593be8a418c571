// What goes wrong is said in one line, with the right exit code, and leaves no partial file behind.

#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// One line on standard error that starts as all errors do, and nothing else anywhere.
void expect_one_line_error(const ProgramResult& result, int exit_code, const std::string& message) {
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_THAT(result.err, StartsWith("emulsion: error: "));
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(result.out, "");
}

class FailingProgram : public ::testing::Test {
  protected:
    FailingProgram() { write_text(scene_, kSmallScene); }

    void expect_only_the_scene() const { EXPECT_THAT(folder_.names(), ElementsAre("small.pbrt")); }

    TemporaryFolder folder_;
    const std::string scene_ = folder_.file("small.pbrt"), exr_ = folder_.file("a.exr"), png_ = folder_.file("a.png");
};

TEST_F(FailingProgram, BadSceneNamesFileLineAndColumn) {
    write_text(scene_, "Film \"rgb\"\nWorldBegin\n  Shape \"sphere\" \"float radius\" [-1]\n");
    expect_one_line_error(run_program({"render", scene_, "-o", exr_}), 1, scene_ + ":3:");
    expect_only_the_scene();
}

TEST_F(FailingProgram, WhatIsNotYetSupportedIsSaid) {
    write_text(scene_, "WorldBegin\nMaterial \"hair\"\n");
    expect_one_line_error(run_program({"render", scene_, "-o", exr_}), 1, "not yet supported");
    expect_only_the_scene();
}

TEST_F(FailingProgram, MissingFiles) {
    expect_one_line_error(run_program({"render", folder_.file("none.pbrt"), "-o", exr_}), 1, "none.pbrt");
    expect_one_line_error(run_program({"develop", folder_.file("none.exr"), "-o", png_}), 1, "none.exr");
    expect_only_the_scene();
}

/// /proc refuses new files even to the superuser.
TEST_F(FailingProgram, UnwritableFolderIsFoundBeforeTheRender) {
    // Were the render to start, this would take hours.
    const std::vector<std::string> long_render{"render", scene_, "--spp", "16000000", "--resolution", "4000x4000"};
    for (const std::string& bad : {std::string("/proc/a"), folder_.file("missing/a")}) {
        auto exr = long_render;
        exr.insert(exr.end(), {"-o", bad + ".exr"});
        expect_one_line_error(run_program(exr), 1, bad + ".exr");
        auto png = long_render;
        png.insert(png.end(), {"-o", exr_, "--png", bad + ".png"});
        expect_one_line_error(run_program(png), 1, bad + ".png");
    }
    expect_only_the_scene();
}

TEST_F(FailingProgram, ReadOnlyFolderIsFoundBeforeTheRender) {
    const std::filesystem::path read_only = folder_.path() / "read-only";
    std::filesystem::create_directory(read_only);
    std::filesystem::permissions(read_only, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    // The superuser may write there all the same, unless that right is taken away.
    const auto without_override = [] {
        if (::geteuid() == 0 && ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE) != 0) ::_exit(126);
    };
    const std::string exr = (read_only / "a.exr").string();
    const ProgramResult result = run_program({"render", scene_, "-o", exr}, {.before = without_override});
    expect_one_line_error(result, 1, exr);
    EXPECT_THAT(result.err,
                StartsWith("emulsion: error: " + exr + ": cannot create a file in its folder: Permission denied"));
    EXPECT_TRUE(std::filesystem::is_empty(read_only));
    std::filesystem::permissions(read_only, std::filesystem::perms::owner_all);
}

/// A file that may not grow past 1 KiB, as on a disk that fills up while it is written.
TEST_F(FailingProgram, FullDiskLeavesNoPartialFile) {
    const auto limit_files = [] {
        const rlimit limit{1024, 1024};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(126);
    };
    expect_one_line_error(run_program({"render", scene_, "-o", exr_, "--quiet"}, {.before = limit_files}), 1, exr_);
    expect_only_the_scene();

    ASSERT_EQ(run_program({"render", scene_, "-o", exr_, "--quiet"}).exit_code, 0);
    for (const std::string name : {"a.png", "a.pfm", "a.hdr"}) {
        const std::string output = folder_.file(name);
        expect_one_line_error(run_program({"develop", exr_, "-o", output}, {.before = limit_files}), 1, output + ": ");
        EXPECT_THAT(folder_.names(), ElementsAre("a.exr", "small.pbrt"));
        // An older file of that name is as it was.
        write_text(output, "precious");
        EXPECT_EQ(run_program({"develop", exr_, "-o", output}, {.before = limit_files}).exit_code, 1);
        EXPECT_EQ(read_text(output), "precious");
        EXPECT_THAT(folder_.names(), ElementsAre("a.exr", name, "small.pbrt"));
        std::filesystem::remove(output);
    }
    for (const char* flag : {"--plates", "--print-preview"}) {
        expect_one_line_error(run_program({"develop", exr_, flag, png_}, {.before = limit_files}), 1, png_);
        EXPECT_THAT(folder_.names(), ElementsAre("a.exr", "small.pbrt"));
    }
}

/// The same on a file system that is really full: a small one in memory, where the machine lets us mount it.
TEST_F(FailingProgram, FullFileSystemLeavesNoPartialFile) {
    const std::filesystem::path full = folder_.path() / "full";
    std::filesystem::create_directory(full);
    constexpr int kCannotMount = 125;
    const auto mount_and_fill = [&full] {
        if (::unshare(CLONE_NEWNS) != 0 && ::unshare(CLONE_NEWNS | CLONE_NEWUSER) != 0) ::_exit(kCannotMount);
        if (::mount("none", full.c_str(), "tmpfs", 0, "size=8k") != 0) ::_exit(kCannotMount);
    };
    // The file system is gone with the child, so it is the program's own message that tells.
    const ProgramResult result =
        run_program({"render", scene_, "-o", (full / "a.exr").string(), "--quiet"}, {.before = mount_and_fill});
    if (result.exit_code == kCannotMount) GTEST_SKIP() << "this machine does not let tests mount a file system";
    expect_one_line_error(result, 1, "No space left on device");
}

TEST_F(FailingProgram, CorruptExrIsRefused) {
    ASSERT_EQ(run_program({"render", scene_, "-o", exr_, "--quiet"}).exit_code, 0);
    const std::string whole = read_text(exr_);
    for (const std::string& broken : {std::string(), std::string("not an EXR at all"), whole.substr(0, 100),
                                      whole.substr(0, whole.size() / 2), whole.substr(0, whole.size() - 1)}) {
        write_text(exr_, broken);
        expect_one_line_error(run_program({"develop", exr_, "-o", png_}), 1, exr_);
        EXPECT_THAT(folder_.names(), ElementsAre("a.exr", "small.pbrt"));
    }
}

TEST_F(FailingProgram, FailingKeepsTheOlderFile) {
    write_text(exr_, "precious");
    write_text(scene_, "nonsense");
    EXPECT_EQ(run_program({"render", scene_, "-o", exr_}).exit_code, 1);
    EXPECT_EQ(read_text(exr_), "precious");
}

class BadUsage : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(BadUsage, IsOneLineAndExitCodeTwo) {
    const TemporaryFolder folder;
    const std::string scene = folder.file("small.pbrt");
    write_text(scene, kSmallScene);
    std::vector<std::string> arguments = GetParam();
    for (std::string& argument : arguments) {
        if (argument == "SCENE") argument = scene;
    }
    expect_one_line_error(run_program(arguments), 2, "");
    EXPECT_THAT(folder.names(), ElementsAre("small.pbrt"));
}

INSTANTIATE_TEST_SUITE_P(
    Arguments, BadUsage,
    ::testing::Values(std::vector<std::string>{}, std::vector<std::string>{"paint"}, std::vector<std::string>{"render"},
                      std::vector<std::string>{"render", "SCENE", "--spp", "0"},
                      std::vector<std::string>{"render", "SCENE", "--spp", "many"},
                      std::vector<std::string>{"render", "SCENE", "--resolution", "640"},
                      std::vector<std::string>{"render", "SCENE", "--resolution", "0x480"},
                      std::vector<std::string>{"render", "SCENE", "--resolution", "640x480x3"},
                      std::vector<std::string>{"render", "SCENE", "--resolution", "640x99999"},
                      std::vector<std::string>{"render", "SCENE", "--model", "spectral:3"},
                      std::vector<std::string>{"render", "SCENE", "--threads", "-1"},
                      std::vector<std::string>{"render", "SCENE", "--seed", "-1"},
                      std::vector<std::string>{"render", "SCENE", "--tonemap", "reinhart-global"},
                      std::vector<std::string>{"render", "SCENE", "--tonemap", "reinhard-global:key=-1"},
                      std::vector<std::string>{"render", "SCENE", "--space", "sRBG"},
                      std::vector<std::string>{"render", "SCENE", "--space", "sRGB", "--rgb"},
                      std::vector<std::string>{"render", "SCENE", "--compression", "jpeg"},
                      std::vector<std::string>{"render", "SCENE", "--compression", "dwaa:level=-1"},
                      std::vector<std::string>{"render", "SCENE", "--checkpoint", "0"},
                      std::vector<std::string>{"render", "SCENE", "--checkpoint", "nan"},
                      std::vector<std::string>{"render", "SCENE", "--checkpoint", "inf"},
                      std::vector<std::string>{"render", "SCENE", "--unknown"},
                      std::vector<std::string>{"render", "SCENE", "-o", "a.png"},
                      std::vector<std::string>{"render", "SCENE", "-o", "a.exr", "--png", "a.exr"},
                      std::vector<std::string>{"develop"}, std::vector<std::string>{"develop", "a.exr"}));

TEST(Help, NamesEveryFlagWithItsDefault) {
    const ProgramResult program = run_program({"--help"});
    EXPECT_EQ(program.exit_code, 0);
    EXPECT_THAT(program.out, HasSubstr("render"));
    EXPECT_THAT(program.out, HasSubstr("develop"));
    EXPECT_THAT(program.out, HasSubstr("Exit codes: 0 done, 1 failed, 2 bad usage"));

    const ProgramResult render = run_program({"render", "--help"});
    EXPECT_EQ(render.exit_code, 0);
    for (const char* flag :
         {"SCENE", "-o", "--png", "--spp", "--resolution", "--threads", "--seed", "--model", "--rgb", "--half",
          "--quiet", "--tonemap", "reinhard-global", "max-to-white", "key=0.18", "cd/m^2", "default"}) {
        EXPECT_THAT(render.out, HasSubstr(flag));
    }
    const ProgramResult develop = run_program({"develop", "--help"});
    EXPECT_EQ(develop.exit_code, 0);
    for (const char* flag : {"-o", "--threads", "--quiet", "--tonemap"}) EXPECT_THAT(develop.out, HasSubstr(flag));
    EXPECT_EQ(run_program({"--version"}).exit_code, 0);
}

}  // namespace
}  // namespace emulsion::testing
