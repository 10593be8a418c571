#include "core/name_key.h"

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(NameKey, LeavesOutCaseAndSeparators) {
    EXPECT_EQ(name_key("FL3.10"), "fl3-10");
    EXPECT_EQ(name_key("fl3_10"), name_key("FL3-10"));
    EXPECT_EQ(name_key("ColorChecker dark skin"), "colorchecker-dark-skin");
    EXPECT_EQ(name_key(""), "");
    EXPECT_NE(name_key("FL31"), name_key("FL3.1"));
}

}  // namespace
}  // namespace emulsion
