// What atomic files refuse, and that nothing is left behind.

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "atomic_file_fixture.h"
#include "core/atomic_file.h"
#include "core/error.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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

TEST_F(AtomicFileTest, TakesTheLongestNameAndNoLonger) {
    const std::string longest(255, 'n');
    AtomicFile file(folder() / longest);
    file.commit();
    EXPECT_THAT(names(), ElementsAre(longest));
    EXPECT_THAT([&] { check_writable(folder() / (longest + "n")); }, throws_io_error("File name too long"));
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

TEST_F(AtomicFileTest, RefusesAFolderAndNamesIt) {
    fs::create_directory(folder() / "sub");
    EXPECT_THAT([&] { const AtomicFile file(folder() / "sub"); }, throws_io_error("is a folder"));
    EXPECT_THAT([&] { const AtomicFile file(folder() / ".."); }, throws_io_error("is a folder"));
    EXPECT_THAT([&] { const AtomicFile file(folder() / "sub" / ""); }, throws_io_error("not a file name"));
    EXPECT_THAT([] { const AtomicFile file(""); }, throws_io_error("not a file name"));
    EXPECT_THAT([&] { const AtomicFile file(folder() / "sub"); },
                testing::Throws<IoError>(testing::Property(&IoError::path, folder() / "sub")));
    EXPECT_THAT(names(), ElementsAre("sub"));
}

TEST_F(AtomicFileTest, RefusesAMissingFolder) {
    EXPECT_THAT([&] { const AtomicFile file(folder() / "missing" / "a.exr"); },
                throws_io_error("No such file or directory"));
    write_text(folder() / "file", "");
    EXPECT_THAT([&] { const AtomicFile file(folder() / "file" / "a.exr"); }, throws_io_error("Not a directory"));
}

TEST_F(AtomicFileTest, RefusesAFolderThatNobodyMayWriteTo) {
    // Not even root makes files here.
    EXPECT_THROW(check_writable("/proc/a.exr"), IoError);
}

TEST_F(AtomicFileTest, RefusesDevicesAndPipes) {
    // As root, a rename would replace the device by a plain file.
    EXPECT_THAT([] { check_writable("/dev/null"); }, throws_io_error("is a device or a pipe"));
    ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
    EXPECT_THAT([&] { check_writable(folder() / "pipe"); }, throws_io_error("is a device or a pipe"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, ObeysPermissions) {
    write_text(folder() / "protected.exr", "keep");
    fs::permissions(folder() / "protected.exr", fs::perms::owner_read);
    const OrdinaryUser user({folder(), folder() / "protected.exr"});
    EXPECT_THAT([&] { check_writable(folder() / "protected.exr"); }, throws_io_error("Permission denied"));
    fs::permissions(folder(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THAT([&] { check_writable(folder() / "new.exr"); }, throws_io_error("Permission denied"));
    fs::permissions(folder(), fs::perms::owner_all);
    EXPECT_EQ(read_text(folder() / "protected.exr"), "keep");
}

TEST_F(AtomicFileTest, ClosedFoldersCantBeCompared) {
    fs::create_directory(folder() / "closed");
    const OrdinaryUser user({folder(), folder() / "closed"});
    fs::permissions(folder() / "closed", fs::perms::none);
    EXPECT_THAT([&] { (void)is_same_file(folder() / "a.exr", folder() / "closed" / "a.exr"); },
                throws_io_error("cannot be looked up: Permission denied"));
    fs::permissions(folder() / "closed", fs::perms::owner_all);
}

TEST_P(EitherAtomicFile, FailedCommitLeavesNoTemporaryFile) {
    {
        AtomicFile file(folder() / "a.exr", GetParam());
        write_text(file.temporary_path(), "new");
        fs::create_directories(folder() / "a.exr" / "in the way");
        EXPECT_THAT([&] { file.commit(); }, throws_io_error("cannot rename"));
    }
    EXPECT_THAT(names(), ElementsAre("a.exr"));
}

TEST_P(EitherAtomicFile, CommitFailsWhenTheFolderIsGone) {
    fs::create_directory(folder() / "sub");
    AtomicFile file(folder() / "sub" / "a.exr", GetParam());
    fs::remove_all(folder() / "sub");
    EXPECT_THAT([&] { file.commit(); }, throws_io_error("cannot rename the temporary file: No such file"));
    EXPECT_THAT(names(), IsEmpty());
}

}  // namespace
}  // namespace emulsion
