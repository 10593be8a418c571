#include "pathtracer/gzip.h"

#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "support/gzip_bytes.h"

namespace emulsion {
namespace {

using testing::gzip_bytes;

/// Why these bytes are refused, or "(no error)".
std::string reason_of(const std::string& bytes, std::size_t most_bytes = kMostInflatedBytes) {
    try {
        static_cast<void>(inflate_gzip("x.gz", bytes, most_bytes));
    } catch (const IoError& error) {
        EXPECT_EQ(error.path(), "x.gz");
        return error.reason();
    }
    return "(no error)";
}

std::string noise(std::size_t size) {
    Pcg32 random(1);
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random.next());
    return bytes;
}

TEST(Gzip, GivesBackWhatWasCompressed) {
    // Shorter and longer than the pieces that are inflated at a time.
    for (const std::string& text :
         {std::string(), std::string("Shape \"sphere\"\n"), noise(65536), noise(1000000), std::string(1000000, 'x')}) {
        EXPECT_TRUE(inflate_gzip("x.gz", gzip_bytes(text)) == text) << text.size();
    }
}

TEST(Gzip, MembersFollowEachOther) {
    EXPECT_EQ(inflate_gzip("x.gz", gzip_bytes("one ") + gzip_bytes("") + gzip_bytes("two")), "one two");
}

TEST(Gzip, RefusesWhatIsNoGzipFile) {
    const std::string damaged = "is damaged, or no gzip file", cut_off = "is cut off: its gzip data has no end";
    EXPECT_EQ(reason_of("Shape \"sphere\""), damaged);
    EXPECT_EQ(reason_of(""), cut_off);
    EXPECT_EQ(reason_of(gzip_bytes("one") + "rest"), damaged);
    const std::string whole = gzip_bytes(noise(1000));
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_EQ(reason_of(whole.substr(0, size)), cut_off) << size;
    std::string flipped = whole;
    flipped[500] = static_cast<char>(flipped[500] ^ 1);  // the checksum is wrong
    EXPECT_EQ(reason_of(flipped), damaged);
}

TEST(Gzip, BombsEndAtTheLimit) {
    const std::string bomb = gzip_bytes(std::string(std::size_t{1} << 24u, '\0'));
    EXPECT_LT(bomb.size(), 20000u);
    EXPECT_EQ(reason_of(bomb, (std::size_t{1} << 24u) - 1), "holds more than 16777215 bytes, compressed by gzip");
    EXPECT_EQ(reason_of(bomb, std::size_t{1} << 24u), "(no error)");
    EXPECT_EQ(reason_of(gzip_bytes("one") + bomb, 3), "holds more than 3 bytes, compressed by gzip");
}

// Whatever bytes are flipped, the result is the text or an error.
TEST(Gzip, DamageIsFound) {
    const std::string text = "WorldBegin " + noise(300), whole = gzip_bytes(text);
    Pcg32 random(3);
    for (int round = 0; round < 5000; ++round) {
        std::string bytes = whole;
        for (int i = 0; i < 3; ++i) bytes[random.next() % bytes.size()] = static_cast<char>(random.next());
        try {
            EXPECT_EQ(inflate_gzip("x.gz", bytes), text);  // changes in the header's time stamp are harmless
        } catch (const IoError&) {
        }
    }
}

}  // namespace
}  // namespace emulsion
