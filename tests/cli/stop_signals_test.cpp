// Ctrl-C at any moment: what there is is written, and no half of a file is left behind.

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "core/atomic_file.h"
#include "film/exr_file.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class StopSignal : public ::testing::Test {
  protected:
    StopSignal() { write_text(scene_, kSmallScene); }

    /// Returns when the child writes its film, or has ended. What is being written has no name, or a hidden one.
    void wait_for_writing(pid_t child) const {
        while (!ended(child)) {
            std::error_code gone;
            for (const auto& opened :
                 std::filesystem::directory_iterator("/proc/" + std::to_string(child) + "/fd", gone)) {
                const std::string name = std::filesystem::read_symlink(opened.path(), gone).string();
                const bool is_temporary = name.ends_with(" (deleted)") || name.ends_with(".tmp");
                if (!name.starts_with(folder_.path().string() + "/") || !is_temporary) continue;
                if (const auto size = std::filesystem::file_size(opened.path(), gone); !gone && size > 0) return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    /// Leaves the child to be waited for.
    static bool ended(pid_t child) {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0;
    }

    TemporaryFolder folder_;
    const std::string scene_ = folder_.file("small.pbrt"), exr_ = folder_.file("a.exr"), png_ = folder_.file("a.png");
    const std::vector<std::string> large_ = {"render", scene_, "-o",      exr_,           "--png",    png_,
                                             "--spp",  "1",    "--quiet", "--resolution", "1200x1000"};
};

TEST_F(StopSignal, WhileFilesAreWrittenItWaitsForThem) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const auto interrupt = [this, signal](pid_t child) {
            wait_for_writing(child);
            ::kill(child, signal);
        };
        EXPECT_EQ(run_program(large_, {.while_running = interrupt}).exit_code, 0);
        EXPECT_THAT(folder_.names(), ElementsAre("a.exr", "a.png", "small.pbrt"));
        EXPECT_EQ(read_exr(exr_).metadata.sample_count, 1200u * 1000u);
        std::filesystem::remove(exr_);
    }
}

TEST_F(StopSignal, ASecondOneEndsTheProcess) {
    const auto insist = [this](pid_t child) {
        wait_for_writing(child);
        while (!ended(child)) {
            ::kill(child, SIGINT);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    };
    EXPECT_EQ(run_program(large_, {.while_running = insist}).exit_code, -1);
    EXPECT_FALSE(std::filesystem::exists(exr_));
}

TEST_F(StopSignal, KilledWhileItWritesItLeavesNothingButTheOldFile) {
    if (AtomicFile(exr_).temporary_path().parent_path() == folder_.path()) {
        GTEST_SKIP() << "no files without a name in " << folder_.path();
    }
    const auto kill = [this](pid_t child) {
        wait_for_writing(child);
        ::kill(child, SIGKILL);
    };
    EXPECT_EQ(run_program(large_, {.while_running = kill}).exit_code, -1);
    EXPECT_THAT(folder_.names(), ElementsAre("small.pbrt"));
    write_text(exr_, "precious");
    EXPECT_EQ(run_program(large_, {.while_running = kill}).exit_code, -1);
    EXPECT_THAT(folder_.names(), ElementsAre("a.exr", "small.pbrt"));
    EXPECT_EQ(read_text(exr_), "precious");
}

TEST_F(StopSignal, WhatTheProcessWasStartedToIgnoreStaysIgnored) {
    // Set here already: the child inherits it, and would otherwise be ended before it comes to that.
    auto* const before = std::signal(SIGINT, SIG_IGN);
    const auto interrupt = [](pid_t child) {
        while (!ended(child)) {
            ::kill(child, SIGINT);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    };
    const ProgramResult result = run_program({"render", scene_, "-o", exr_, "--spp", "500"},
                                             {.signals = StopSignals::inherited, .while_running = interrupt});
    std::signal(SIGINT, before);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("stopped")));
    EXPECT_EQ(read_exr(exr_).metadata.samples_per_pixel, 500);
}

}  // namespace
}  // namespace emulsion::testing
