#include "core/text_file.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::Property;
using testing::Throws;

std::filesystem::path folder() { return std::filesystem::path(testing::TempDir()) / "emulsion_text_file_test"; }

auto throws_io_error(const std::string& reason) {
    return Throws<IoError>(Property(&IoError::reason, HasSubstr(reason)));
}

TEST(ReadTextFile, GivesEveryByte) {
    std::filesystem::create_directories(folder());
    const std::filesystem::path path = folder() / "bytes.txt";
    std::string content;
    for (int i = 0; i < 200001; ++i) content += static_cast<char>(i % 251);
    std::ofstream(path, std::ios::binary) << content;
    EXPECT_EQ(read_text_file(path), content);
    std::ofstream(path, std::ios::binary).flush();
    EXPECT_EQ(read_text_file(path), "");
    std::filesystem::remove_all(folder());
}

TEST(ReadTextFile, SaysWhyItCant) {
    EXPECT_THAT([] { static_cast<void>(read_text_file(folder() / "none.txt")); }, throws_io_error("no such file"));
    EXPECT_THAT([] { static_cast<void>(read_text_file(testing::TempDir())); }, throws_io_error("is a folder"));
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
