// The C interface turns every exception into a code.

#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "capi/emulsion.h"
#include "capi/status.h"
#include "core/error.h"

namespace emulsion {
namespace {

TEST(CapiStatus, ExceptionsBecomeCodes) {
    using capi::guarded;
    EXPECT_EQ(guarded([] {}), EMULSION_OK);
    EXPECT_EQ(guarded([] { throw std::invalid_argument("what is wrong"); }), EMULSION_INVALID_ARGUMENT);
    EXPECT_STREQ(emulsion_last_error(), "what is wrong");
    EXPECT_EQ(guarded([] { throw IoError("file", "why"); }), EMULSION_IO_ERROR);
    EXPECT_STREQ(emulsion_last_error(), "file: why");
    EXPECT_EQ(guarded([] { throw std::bad_alloc(); }), EMULSION_OUT_OF_MEMORY);
    EXPECT_EQ(guarded([] { static_cast<void>(std::vector<int>(static_cast<std::size_t>(-1))); }),
              EMULSION_OUT_OF_MEMORY);
    EXPECT_EQ(guarded([] { throw std::runtime_error("unforeseen"); }), EMULSION_INTERNAL_ERROR);
    EXPECT_STREQ(emulsion_last_error(), "unforeseen");
    EXPECT_EQ(guarded([] { throw 1; }), EMULSION_INTERNAL_ERROR);
    EXPECT_EQ(guarded([] { throw std::runtime_error(std::string(5000, 'x')); }), EMULSION_INTERNAL_ERROR);
    EXPECT_EQ(std::string(emulsion_last_error()), std::string(2047, 'x'));
}

TEST(CapiStatus, ErrorsBelongToTheirThread) {
    EXPECT_EQ(emulsion_tile_clear(nullptr), EMULSION_INVALID_ARGUMENT);
    std::thread([] { EXPECT_STREQ(emulsion_last_error(), ""); }).join();
    EXPECT_STREQ(emulsion_last_error(), "tile is NULL");
}

}  // namespace
}  // namespace emulsion
