#include "display/code_value.h"

#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(CodeScale, FullRangeHasAllCodes) {
    EXPECT_EQ(code_scale(1, FullRange{}), (CodeScale{0, 1}));
    EXPECT_EQ(code_scale(8, FullRange{}), (CodeScale{0, 255}));
    EXPECT_EQ(code_scale(10, FullRange{}), (CodeScale{0, 1023}));
    EXPECT_EQ(code_scale(16, FullRange{}), (CodeScale{0, 65535}));
}

// ITU-R BT.2100-2, table 9: 64 and 940 of 10 bits, 256 and 3760 of 12.
TEST(CodeScale, NarrowRangeIsThatOfVideo) {
    EXPECT_EQ(code_scale(8, NarrowRange{}), (CodeScale{16, 235}));
    EXPECT_EQ(code_scale(10, NarrowRange{}), (CodeScale{64, 940}));
    EXPECT_EQ(code_scale(12, NarrowRange{}), (CodeScale{256, 3760}));
    EXPECT_EQ(code_scale(16, NarrowRange{}), (CodeScale{4096, 60160}));
}

TEST(CodeScale, RejectsOtherNumbersOfBits) {
    for (const int bits : {-1, 0, 17}) EXPECT_THROW((void)code_scale(bits, FullRange{}), std::invalid_argument);
    for (const int bits : {1, 7, 17}) EXPECT_THROW((void)code_scale(bits, NarrowRange{}), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
