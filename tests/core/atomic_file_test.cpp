#include "core/atomic_file.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "atomic_file_fixture.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST_F(AtomicFileTest, AppearsOnlyWhenCommitted) {
    AtomicFile file(folder() / "a.exr");
    EXPECT_EQ(file.path(), folder() / "a.exr");
    EXPECT_EQ(file.temporary_path().parent_path(), folder()) << "a rename is whole only within a file system";
    write_text(file.temporary_path(), "whole");
    EXPECT_FALSE(fs::exists(file.path()));
    file.commit();
    EXPECT_EQ(read_text(file.path()), "whole");
    EXPECT_THAT(names(), ElementsAre("a.exr"));
}

TEST_F(AtomicFileTest, LeavesNothingWhenDropped) {
    { const AtomicFile file(folder() / "a.exr"); }
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(AtomicFileTest, LeavesTheOldFileWhenDropped) {
    write_text(folder() / "a.exr", "old");
    {
        const AtomicFile file(folder() / "a.exr");
        write_text(file.temporary_path(), "half of the n");
    }
    EXPECT_THAT(names(), ElementsAre("a.exr"));
    EXPECT_EQ(read_text(folder() / "a.exr"), "old");
}

TEST_F(AtomicFileTest, ReplacesTheOldFile) {
    write_text(folder() / "a.exr", "old and longer");
    AtomicFile file(folder() / "a.exr");
    write_text(file.temporary_path(), "new");
    file.commit();
    EXPECT_EQ(read_text(folder() / "a.exr"), "new");
    EXPECT_THAT(names(), ElementsAre("a.exr"));
}

TEST_F(AtomicFileTest, AReaderOfTheOldFileKeepsIt) {
    write_text(folder() / "a.exr", "old");
    std::ifstream reader(folder() / "a.exr");
    AtomicFile file(folder() / "a.exr");
    write_text(file.temporary_path(), "new");
    file.commit();
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
}

TEST_F(AtomicFileTest, NewFilesHaveThePermissionsOfAnOrdinaryFile) {
    write_text(folder() / "ordinary", "");
    AtomicFile file(folder() / "a.exr");
    file.commit();
    EXPECT_EQ(fs::status(folder() / "a.exr").permissions(), fs::status(folder() / "ordinary").permissions());
}

TEST_F(AtomicFileTest, TakesANameWithoutAFolder) {
    const fs::path before = fs::current_path();
    fs::current_path(folder());
    {
        AtomicFile file("plain.exr");
        write_text(file.temporary_path(), "here");
        file.commit();
    }
    fs::current_path(before);
    EXPECT_THAT(names(), ElementsAre("plain.exr"));
    EXPECT_EQ(read_text(folder() / "plain.exr"), "here");
}

TEST_F(AtomicFileTest, FollowsASymbolicLink) {
    fs::create_directory(folder() / "elsewhere");
    write_text(folder() / "elsewhere" / "real.exr", "old");
    fs::create_symlink("elsewhere/real.exr", folder() / "link.exr");
    AtomicFile file(folder() / "link.exr");
    write_text(file.temporary_path(), "new");
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder() / "link.exr"));
    EXPECT_EQ(read_text(folder() / "elsewhere" / "real.exr"), "new");
}

TEST_F(AtomicFileTest, CreatesWhatADanglingLinkPointsTo) {
    fs::create_directory(folder() / "elsewhere");
    fs::create_symlink("elsewhere/second", folder() / "first");
    fs::create_symlink(folder() / "elsewhere" / "real.exr", folder() / "elsewhere" / "second");
    AtomicFile file(folder() / "first");
    EXPECT_EQ(file.temporary_path().parent_path(), folder() / "elsewhere");
    write_text(file.temporary_path(), "new");
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder() / "first"));
    EXPECT_TRUE(fs::is_symlink(folder() / "elsewhere" / "second"));
    EXPECT_EQ(read_text(folder() / "elsewhere" / "real.exr"), "new");
    EXPECT_THAT(names(), ElementsAre("elsewhere", "first"));
}

TEST_F(AtomicFileTest, AReplacedFileKeepsItsPermissions) {
    // Among them one that would keep the writer from reading and one wider than any usual mask.
    for (const unsigned mode : {0600u, 0640u, 0200u, 0666u, 0755u}) {
        write_text(folder() / "a.exr", "old");
        fs::permissions(folder() / "a.exr", static_cast<fs::perms>(mode));
        AtomicFile file(folder() / "a.exr");
        EXPECT_EQ(fs::status(file.temporary_path()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
        write_text(file.temporary_path(), "new");
        file.commit();
        EXPECT_EQ(static_cast<unsigned>(fs::status(folder() / "a.exr").permissions()), mode);
        fs::permissions(folder() / "a.exr", fs::perms::owner_all);
        EXPECT_EQ(read_text(folder() / "a.exr"), "new");
        fs::remove(folder() / "a.exr");
    }
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

TEST_F(AtomicFileTest, ConcurrentWritersEachWriteAWholeFile) {
    constexpr int kWriters = 8, kRounds = 20;
    constexpr std::size_t kSize = 64 * 1024;
    std::vector<std::thread> writers;
    writers.reserve(kWriters);
    for (int w = 0; w < kWriters; ++w) {
        writers.emplace_back([&, w] {
            for (int round = 0; round < kRounds; ++round) {
                AtomicFile file(folder() / "shared.exr");
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
