#include "core/atomic_file.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "atomic_file_fixture.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

// Those of atomic_file_refusal_test.cpp too.
INSTANTIATE_TEST_SUITE_P(AtomicFile, EitherAtomicFile, testing::Values(TemporaryName::none, TemporaryName::hidden),
                         name_of);

TEST_P(EitherAtomicFile, AppearsOnlyWhenCommitted) {
    AtomicFile file(folder() / "a.exr", GetParam());
    EXPECT_EQ(file.path(), folder() / "a.exr");
    write_text(file.temporary_path(), "whole");
    EXPECT_FALSE(fs::exists(file.path()));
    file.commit();
    EXPECT_EQ(read_text(file.path()), "whole");
    EXPECT_THAT(names(), ElementsAre("a.exr"));
}

TEST_P(EitherAtomicFile, LeavesNothingWhenDropped) {
    { const AtomicFile file(folder() / "a.exr", GetParam()); }
    EXPECT_THAT(names(), IsEmpty());
}

TEST_P(EitherAtomicFile, LeavesTheOldFileWhenDropped) {
    write_text(folder() / "a.exr", "old");
    {
        const AtomicFile file(folder() / "a.exr", GetParam());
        write_text(file.temporary_path(), "half of the n");
    }
    EXPECT_THAT(names(), ElementsAre("a.exr"));
    EXPECT_EQ(read_text(folder() / "a.exr"), "old");
}

TEST_P(EitherAtomicFile, ReplacesTheOldFile) {
    write_text(folder() / "a.exr", "old and longer");
    AtomicFile file(folder() / "a.exr", GetParam());
    write_text(file.temporary_path(), "new");
    file.commit();
    EXPECT_EQ(read_text(folder() / "a.exr"), "new");
    EXPECT_THAT(names(), ElementsAre("a.exr"));
}

TEST_P(EitherAtomicFile, AReaderOfTheOldFileKeepsIt) {
    write_text(folder() / "a.exr", "old");
    std::ifstream reader(folder() / "a.exr");
    AtomicFile file(folder() / "a.exr", GetParam());
    write_text(file.temporary_path(), "new");
    file.commit();
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
}

TEST_P(EitherAtomicFile, NewFilesHaveThePermissionsOfAnOrdinaryFile) {
    write_text(folder() / "ordinary", "");
    AtomicFile file(folder() / "a.exr", GetParam());
    file.commit();
    EXPECT_EQ(fs::status(folder() / "a.exr").permissions(), fs::status(folder() / "ordinary").permissions());
}

TEST_P(EitherAtomicFile, TakesANameWithoutAFolder) {
    const fs::path before = fs::current_path();
    fs::current_path(folder());
    {
        AtomicFile file("plain.exr", GetParam());
        write_text(file.temporary_path(), "here");
        file.commit();
    }
    fs::current_path(before);
    EXPECT_THAT(names(), ElementsAre("plain.exr"));
    EXPECT_EQ(read_text(folder() / "plain.exr"), "here");
}

TEST_P(EitherAtomicFile, FollowsASymbolicLink) {
    fs::create_directory(folder() / "elsewhere");
    write_text(folder() / "elsewhere" / "real.exr", "old");
    fs::create_symlink("elsewhere/real.exr", folder() / "link.exr");
    AtomicFile file(folder() / "link.exr", GetParam());
    write_text(file.temporary_path(), "new");
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder() / "link.exr"));
    EXPECT_EQ(read_text(folder() / "elsewhere" / "real.exr"), "new");
}

TEST_P(EitherAtomicFile, CreatesWhatADanglingLinkPointsTo) {
    fs::create_directory(folder() / "elsewhere");
    fs::create_symlink("elsewhere/second", folder() / "first");
    fs::create_symlink(folder() / "elsewhere" / "real.exr", folder() / "elsewhere" / "second");
    AtomicFile file(folder() / "first", GetParam());
    write_text(file.temporary_path(), "new");
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder() / "first"));
    EXPECT_TRUE(fs::is_symlink(folder() / "elsewhere" / "second"));
    EXPECT_EQ(read_text(folder() / "elsewhere" / "real.exr"), "new");
    EXPECT_THAT(names(), ElementsAre("elsewhere", "first"));
}

TEST_P(EitherAtomicFile, AReplacedFileKeepsItsPermissions) {
    // Among them one that would keep the writer from reading and one wider than any usual mask.
    for (const unsigned mode : {0600u, 0640u, 0200u, 0666u, 0755u}) {
        write_text(folder() / "a.exr", "old");
        fs::permissions(folder() / "a.exr", static_cast<fs::perms>(mode));
        AtomicFile file(folder() / "a.exr", GetParam());
        EXPECT_EQ(fs::status(file.temporary_path()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
        write_text(file.temporary_path(), "new");
        file.commit();
        EXPECT_EQ(static_cast<unsigned>(fs::status(folder() / "a.exr").permissions()), mode);
        fs::permissions(folder() / "a.exr", fs::perms::owner_all);
        EXPECT_EQ(read_text(folder() / "a.exr"), "new");
        fs::remove(folder() / "a.exr");
    }
}

/// Runs `work`, which ends in a SIGKILL, in a process of its own.
template <class Work>
void killed_after(const Work& work) {
    const ::pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        work();
        ::_exit(1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
}

TEST_F(AtomicFileTest, AKilledProcessLeavesNothing) {
    // A file system that has no files without a name gives them hidden ones.
    if (AtomicFile(folder() / "a.exr").temporary_path().parent_path() == folder()) GTEST_SKIP() << folder();
    killed_after([this] {
        const AtomicFile file(folder() / "a.exr");
        write_text(file.temporary_path(), "half");
        ::kill(::getpid(), SIGKILL);
    });
    EXPECT_THAT(names(), IsEmpty());
    write_text(folder() / "a.exr", "old");
    killed_after([this] {
        const AtomicFile file(folder() / "a.exr");
        write_text(file.temporary_path(), "half");
        ::kill(::getpid(), SIGKILL);
    });
    EXPECT_THAT(names(), ElementsAre("a.exr"));
    EXPECT_EQ(read_text(folder() / "a.exr"), "old");
}

TEST_F(AtomicFileTest, AKilledProcessLeavesAHiddenName) {
    killed_after([this] {
        const AtomicFile file(folder() / "a.exr", TemporaryName::hidden);
        ::kill(::getpid(), SIGKILL);
    });
    EXPECT_THAT(names(), ElementsAre(StartsWith(".a.exr.")));
}

TEST_F(AtomicFileTest, KnowsOneFileByItsManyNames) {
    const fs::path before = fs::current_path();
    fs::current_path(folder());
    fs::create_directory("sub");
    fs::create_directory_symlink("sub", "also");
    fs::create_symlink("sub/a", "dangling");
    EXPECT_TRUE(is_same_file("a", "a"));
    EXPECT_TRUE(is_same_file("a", "./a"));
    EXPECT_TRUE(is_same_file("a", folder() / "a"));
    EXPECT_TRUE(is_same_file("a", "sub/../a"));
    EXPECT_TRUE(is_same_file("sub/a", "also/a"));
    EXPECT_TRUE(is_same_file("sub/a", "dangling"));
    EXPECT_FALSE(is_same_file("a", "b"));
    EXPECT_FALSE(is_same_file("a", "sub/a"));
    EXPECT_FALSE(is_same_file("a", "dangling"));
    write_text("sub/a", "");
    EXPECT_TRUE(is_same_file("also/a", "dangling"));
    EXPECT_FALSE(is_same_file("a", "dangling"));
    fs::current_path(before);
}

TEST_F(AtomicFileTest, CheckWritableLeavesNoTrace) {
    check_writable(folder() / "a.exr");
    EXPECT_THAT(names(), IsEmpty());
    write_text(folder() / "b.exr", "old");
    check_writable(folder() / "b.exr");
    EXPECT_EQ(read_text(folder() / "b.exr"), "old");
}

TEST_P(EitherAtomicFile, ConcurrentWritersEachWriteAWholeFile) {
    constexpr int kWriters = 8, kRounds = 20;
    constexpr std::size_t kSize = 64 * 1024;
    std::vector<std::thread> writers;
    writers.reserve(kWriters);
    for (int w = 0; w < kWriters; ++w) {
        writers.emplace_back([&, w] {
            for (int round = 0; round < kRounds; ++round) {
                AtomicFile file(folder() / "shared.exr", GetParam());
                write_text(file.temporary_path(), std::string(kSize, static_cast<char>('a' + w)));
                file.commit();
                const std::string seen = read_text(folder() / "shared.exr");
                EXPECT_EQ(seen, std::string(kSize, seen.at(0))) << "a mixture of two writers, or a part of one";
            }
        });
    }
    for (std::thread& writer : writers) writer.join();
    EXPECT_THAT(names(), ElementsAre("shared.exr"));
}

}  // namespace
}  // namespace emulsion
