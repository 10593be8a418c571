#include "core/text_file.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::Property;
using testing::Throws;

auto throws_io_error(const std::string& reason) {
    return Throws<IoError>(Property(&IoError::reason, HasSubstr(reason)));
}

TEST(ReadTextFile, GivesEveryByte) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "bytes.txt";
    std::string content;
    for (int i = 0; i < 200001; ++i) content += static_cast<char>(i % 251);
    write_text(path, content);
    EXPECT_EQ(read_text_file(path), content);
    write_text(path, "");
    EXPECT_EQ(read_text_file(path), "");
}

TEST(ReadTextFile, SaysWhyItCant) {
    const TemporaryFolder folder;
    EXPECT_THAT([&] { static_cast<void>(read_text_file(folder.path() / "none.txt")); },
                throws_io_error("No such file or directory"));
    EXPECT_THAT([&] { static_cast<void>(read_text_file(folder.path())); }, throws_io_error("is a folder"));
    EXPECT_THAT([] { static_cast<void>(read_text_file("/dev/zero")); }, throws_io_error("no file that can be read"));
}

/// The memory of this process is a file that opens and, at address 0, can't be read.
TEST(ReadTextFile, NotesFailuresAfterOpening) {
    const std::filesystem::path memory = "/proc/self/mem";
    if (!std::filesystem::exists(memory)) GTEST_SKIP() << "no " << memory;
    EXPECT_THAT([&] { static_cast<void>(read_text_file(memory)); }, throws_io_error("reading failed"));
}

}  // namespace
}  // namespace emulsion
