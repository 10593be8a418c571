// Nobody may be listening: a full disk behind standard output or standard error, a pipe without a reader, a closed
// stream. The files are written all the same.

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

/// Ways in which a stream can lose what is written to it; each is done in the child process.
void to_full_device(int stream) {
    const int full = ::open("/dev/full", O_WRONLY);
    if (full < 0 || ::dup2(full, stream) < 0) ::_exit(126);
}
void to_pipe_without_reader(int stream) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0 || ::dup2(ends[1], stream) < 0) ::_exit(126);
    ::close(ends[0]);
    ::close(ends[1]);
}
void to_nowhere(int stream) { ::close(stream); }

struct Loss {
    std::string name;
    void (*lose)(int stream);
    int reason;
};

class LostStream : public ::testing::TestWithParam<Loss> {
  protected:
    LostStream() { write_text(scene_, kSmallScene); }

    [[nodiscard]] RunOptions losing(int stream) const {
        return {.before = [lose = GetParam().lose, stream] { lose(stream); }};
    }
    [[nodiscard]] std::string error() const {
        return "emulsion: error: standard output was lost: " + std::string(std::strerror(GetParam().reason)) + "\n";
    }

    TemporaryFolder folder_;
    const std::string scene_ = folder_.file("small.pbrt"), exr_ = folder_.file("a.exr"), png_ = folder_.file("a.png");
};

TEST_P(LostStream, StandardErrorChangesNothing) {
    const ProgramResult done = run_program({"render", scene_, "-o", exr_, "--png", png_}, losing(STDERR_FILENO));
    EXPECT_EQ(done.exit_code, 0);
    EXPECT_THAT(done.out, HasSubstr("wrote " + png_));
    EXPECT_THAT(folder_.names(), ElementsAre("a.exr", "a.png", "small.pbrt"));
    EXPECT_EQ(run_program({"develop", exr_, "-o", png_, "--tonemap", "max-to-white"}, losing(STDERR_FILENO)).exit_code,
              0);

    EXPECT_EQ(run_program({"render", folder_.file("missing.pbrt")}, losing(STDERR_FILENO)).exit_code, 1);
    EXPECT_EQ(run_program({"render"}, losing(STDERR_FILENO)).exit_code, 2);
}

TEST_P(LostStream, StandardOutputIsAnErrorOnceTheFilesAreWritten) {
    const ProgramResult render = run_program({"render", scene_, "-o", exr_, "--png", png_}, losing(STDOUT_FILENO));
    EXPECT_EQ(render.exit_code, 1);
    EXPECT_THAT(render.err, HasSubstr(error()));
    EXPECT_THAT(folder_.names(), ElementsAre("a.exr", "a.png", "small.pbrt"));

    const std::string again = folder_.file("again.png");
    const ProgramResult develop = run_program({"develop", exr_, "-o", again}, losing(STDOUT_FILENO));
    EXPECT_EQ(develop.exit_code, 1);
    EXPECT_EQ(develop.err, error());
    EXPECT_EQ(read_text(again), read_text(png_));

    const ProgramResult help = run_program({"--help"}, losing(STDOUT_FILENO));
    EXPECT_EQ(help.exit_code, 1);
    EXPECT_THAT(help.err, MatchesRegex("emulsion: error: standard output was lost.*\n"));
}

TEST_P(LostStream, StandardOutputIsNotMissedByTheQuiet) {
    const ProgramResult render = run_program({"render", scene_, "-o", exr_, "--quiet"}, losing(STDOUT_FILENO));
    EXPECT_EQ(render.exit_code, 0);
    EXPECT_EQ(render.err, "");
}

INSTANTIATE_TEST_SUITE_P(All, LostStream,
                         ::testing::Values(Loss{"FullDevice", to_full_device, ENOSPC},
                                           Loss{"PipeWithoutReader", to_pipe_without_reader, EPIPE},
                                           Loss{"Closed", to_nowhere, EBADF}),
                         [](const auto& loss) { return loss.param.name; });

}  // namespace
}  // namespace emulsion::testing
