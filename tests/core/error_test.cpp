#include "core/error.h"

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(IoError, SaysPathAndReason) {
    const IoError error("folder/file.exr", "is a folder");
    EXPECT_STREQ(error.what(), "folder/file.exr: is a folder");
    EXPECT_EQ(error.path(), "folder/file.exr");
    EXPECT_EQ(error.reason(), "is a folder");
}

TEST(IoError, IsCaughtAsARuntimeError) { EXPECT_THROW(throw IoError("a", "b"), std::runtime_error); }

}  // namespace
}  // namespace emulsion
