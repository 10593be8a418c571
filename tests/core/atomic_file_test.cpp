#include "core/atomic_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace emulsion {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Property;
using testing::Throws;

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

auto throws_io_error(const std::string& reason) {
    return Throws<IoError>(Property(&IoError::reason, HasSubstr(reason)));
}

/// A folder of its own for each test, gone afterwards.
class AtomicFileTest : public testing::Test {
  protected:
    AtomicFileTest() {
        std::string pattern = (fs::temp_directory_path() / "emulsion-atomic-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw IoError(pattern, "cannot be made");
        folder_ = pattern;
    }
    ~AtomicFileTest() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    [[nodiscard]] const fs::path& folder() const { return folder_; }
    [[nodiscard]] std::vector<std::string> names() const {
        std::set<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_)) found.insert(entry.path().filename().string());
        return {found.begin(), found.end()};
    }

  private:
    fs::path folder_;
};

/// Makes the tests' root, who may write everywhere, an ordinary user who owns the files given, as long as it lives.
class OrdinaryUser {
  public:
    explicit OrdinaryUser(const std::vector<fs::path>& owned) {
        if (!was_root_) return;
        for (const fs::path& path : owned) EXPECT_EQ(::chown(path.c_str(), kNobody, kNobody), 0);
        EXPECT_EQ(::seteuid(kNobody), 0);
    }
    ~OrdinaryUser() {
        if (!was_root_) return;
        EXPECT_EQ(::seteuid(0), 0);
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;

  private:
    static constexpr unsigned kNobody = 65534;
    bool was_root_ = ::geteuid() == 0;
};

TEST_F(AtomicFileTest, AppearsOnlyWhenCommitted) {
    AtomicFile file(folder() / "a.exr");
    EXPECT_EQ(file.path(), folder() / "a.exr");
    EXPECT_EQ(file.temporary_path().parent_path(), folder()) << "a rename is whole only within a file system";
    write(file.temporary_path(), "whole");
    EXPECT_FALSE(fs::exists(file.path()));
    file.commit();
    EXPECT_EQ(read(file.path()), "whole");
    EXPECT_THAT(names(), ElementsAre("a.exr"));
}

TEST_F(AtomicFileTest, LeavesNothingWhenDropped) {
    { const AtomicFile file(folder() / "a.exr"); }
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(AtomicFileTest, LeavesTheOldFileWhenDropped) {
    write(folder() / "a.exr", "old");
    {
        const AtomicFile file(folder() / "a.exr");
        write(file.temporary_path(), "half of the n");
    }
    EXPECT_THAT(names(), ElementsAre("a.exr"));
    EXPECT_EQ(read(folder() / "a.exr"), "old");
}

TEST_F(AtomicFileTest, ReplacesTheOldFile) {
    write(folder() / "a.exr", "old and longer");
    AtomicFile file(folder() / "a.exr");
    write(file.temporary_path(), "new");
    file.commit();
    EXPECT_EQ(read(folder() / "a.exr"), "new");
    EXPECT_THAT(names(), ElementsAre("a.exr"));
}

TEST_F(AtomicFileTest, AReaderOfTheOldFileKeepsIt) {
    write(folder() / "a.exr", "old");
    std::ifstream reader(folder() / "a.exr");
    AtomicFile file(folder() / "a.exr");
    write(file.temporary_path(), "new");
    file.commit();
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
}

TEST_F(AtomicFileTest, NewFilesHaveThePermissionsOfAnOrdinaryFile) {
    write(folder() / "ordinary", "");
    AtomicFile file(folder() / "a.exr");
    file.commit();
    EXPECT_EQ(fs::status(folder() / "a.exr").permissions(), fs::status(folder() / "ordinary").permissions());
}

TEST_F(AtomicFileTest, TakesANameWithoutAFolder) {
    const fs::path before = fs::current_path();
    fs::current_path(folder());
    {
        AtomicFile file("plain.exr");
        write(file.temporary_path(), "here");
        file.commit();
    }
    fs::current_path(before);
    EXPECT_THAT(names(), ElementsAre("plain.exr"));
    EXPECT_EQ(read(folder() / "plain.exr"), "here");
}

TEST_F(AtomicFileTest, TakesTheLongestNameAndNoLonger) {
    const std::string longest(255, 'n');
    AtomicFile file(folder() / longest);
    file.commit();
    EXPECT_THAT(names(), ElementsAre(longest));
    EXPECT_THAT([&] { check_writable(folder() / (longest + "n")); }, throws_io_error("File name too long"));
}

TEST_F(AtomicFileTest, FollowsASymbolicLink) {
    fs::create_directory(folder() / "elsewhere");
    write(folder() / "elsewhere" / "real.exr", "old");
    fs::create_symlink("elsewhere/real.exr", folder() / "link.exr");
    AtomicFile file(folder() / "link.exr");
    write(file.temporary_path(), "new");
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder() / "link.exr"));
    EXPECT_EQ(read(folder() / "elsewhere" / "real.exr"), "new");
}

TEST_F(AtomicFileTest, CreatesWhatADanglingLinkPointsTo) {
    fs::create_directory(folder() / "elsewhere");
    fs::create_symlink("elsewhere/second", folder() / "first");
    fs::create_symlink(folder() / "elsewhere" / "real.exr", folder() / "elsewhere" / "second");
    AtomicFile file(folder() / "first");
    EXPECT_EQ(file.temporary_path().parent_path(), folder() / "elsewhere");
    write(file.temporary_path(), "new");
    file.commit();
    EXPECT_TRUE(fs::is_symlink(folder() / "first"));
    EXPECT_TRUE(fs::is_symlink(folder() / "elsewhere" / "second"));
    EXPECT_EQ(read(folder() / "elsewhere" / "real.exr"), "new");
    EXPECT_THAT(names(), ElementsAre("elsewhere", "first"));
}

TEST_F(AtomicFileTest, RefusesLinksThatLeadNowhere) {
    fs::create_symlink("b", folder() / "a");
    fs::create_symlink("a", folder() / "b");
    EXPECT_THAT([&] { check_writable(folder() / "a"); }, throws_io_error("Too many levels of symbolic links"));
    fs::create_symlink("missing/a.exr", folder() / "c");
    EXPECT_THAT([&] { check_writable(folder() / "c"); }, throws_io_error("No such file or directory"));
    fs::create_symlink("missing/", folder() / "d");
    EXPECT_THAT([&] { check_writable(folder() / "d"); }, throws_io_error("points to a folder"));
}

TEST_F(AtomicFileTest, AReplacedFileKeepsItsPermissions) {
    // Among them one that would keep the writer from reading and one wider than any usual mask.
    for (const unsigned mode : {0600u, 0640u, 0200u, 0666u, 0755u}) {
        write(folder() / "a.exr", "old");
        fs::permissions(folder() / "a.exr", static_cast<fs::perms>(mode));
        AtomicFile file(folder() / "a.exr");
        EXPECT_EQ(fs::status(file.temporary_path()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
        write(file.temporary_path(), "new");
        file.commit();
        EXPECT_EQ(static_cast<unsigned>(fs::status(folder() / "a.exr").permissions()), mode);
        fs::permissions(folder() / "a.exr", fs::perms::owner_all);
        EXPECT_EQ(read(folder() / "a.exr"), "new");
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
    write("sub/a", "");
    EXPECT_TRUE(is_same_file("also/a", "dangling"));
    EXPECT_FALSE(is_same_file("a", "dangling"));
    fs::current_path(before);
}

TEST_F(AtomicFileTest, RefusesAFolderAndNamesIt) {
    fs::create_directory(folder() / "sub");
    EXPECT_THAT([&] { const AtomicFile file(folder() / "sub"); }, throws_io_error("is a folder"));
    EXPECT_THAT([&] { const AtomicFile file(folder() / ".."); }, throws_io_error("is a folder"));
    EXPECT_THAT([&] { const AtomicFile file(folder() / "sub" / ""); }, throws_io_error("not a file name"));
    EXPECT_THAT([] { const AtomicFile file(""); }, throws_io_error("not a file name"));
    EXPECT_THAT([&] { const AtomicFile file(folder() / "sub"); },
                Throws<IoError>(Property(&IoError::path, folder() / "sub")));
    EXPECT_THAT(names(), ElementsAre("sub"));
}

TEST_F(AtomicFileTest, RefusesAMissingFolder) {
    EXPECT_THAT([&] { const AtomicFile file(folder() / "missing" / "a.exr"); },
                throws_io_error("No such file or directory"));
    write(folder() / "file", "");
    EXPECT_THAT([&] { const AtomicFile file(folder() / "file" / "a.exr"); }, throws_io_error("Not a directory"));
}

TEST_F(AtomicFileTest, RefusesAFolderThatNobodyMayWriteTo) {
    // Not even root makes files here.
    EXPECT_THROW(check_writable("/proc/a.exr"), IoError);
    EXPECT_THROW(check_writable("/sys/a.exr"), IoError);
}

TEST_F(AtomicFileTest, RefusesDevicesAndPipes) {
    // As root, a rename would replace the device by a plain file.
    EXPECT_THAT([] { check_writable("/dev/null"); }, throws_io_error("is a device or a pipe"));
    ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
    EXPECT_THAT([&] { check_writable(folder() / "pipe"); }, throws_io_error("is a device or a pipe"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, ObeysPermissions) {
    write(folder() / "protected.exr", "keep");
    fs::permissions(folder() / "protected.exr", fs::perms::owner_read);
    const OrdinaryUser user({folder(), folder() / "protected.exr"});
    EXPECT_THAT([&] { check_writable(folder() / "protected.exr"); }, throws_io_error("Permission denied"));
    fs::permissions(folder(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THAT([&] { check_writable(folder() / "new.exr"); }, throws_io_error("Permission denied"));
    fs::permissions(folder(), fs::perms::owner_all);
    EXPECT_EQ(read(folder() / "protected.exr"), "keep");
}

TEST_F(AtomicFileTest, FailedCommitLeavesNoTemporaryFile) {
    {
        AtomicFile file(folder() / "a.exr");
        write(file.temporary_path(), "new");
        fs::create_directories(folder() / "a.exr" / "in the way");
        EXPECT_THAT([&] { file.commit(); }, throws_io_error("cannot rename"));
    }
    EXPECT_THAT(names(), ElementsAre("a.exr"));
}

TEST_F(AtomicFileTest, CommitFailsWhenTheTemporaryFileIsGone) {
    AtomicFile file(folder() / "a.exr");
    fs::remove(file.temporary_path());
    EXPECT_THAT([&] { file.commit(); }, throws_io_error("cannot reopen"));
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(AtomicFileTest, CheckWritableLeavesNoTrace) {
    check_writable(folder() / "a.exr");
    EXPECT_THAT(names(), IsEmpty());
    write(folder() / "b.exr", "old");
    check_writable(folder() / "b.exr");
    EXPECT_EQ(read(folder() / "b.exr"), "old");
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
                write(file.temporary_path(), std::string(kSize, static_cast<char>('a' + w)));
                file.commit();
                const std::string seen = read(folder() / "shared.exr");
                EXPECT_EQ(seen, std::string(kSize, seen.at(0))) << "a mixture of two writers, or a part of one";
            }
        });
    }
    for (std::thread& writer : writers) writer.join();
    EXPECT_THAT(names(), ElementsAre("shared.exr"));
}

}  // namespace
}  // namespace emulsion
