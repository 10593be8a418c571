#include "core/content_hash.h"

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

std::string hash_of(const std::string& text) {
    ContentHash hash;
    hash.add(text);
    return hash.hex();
}

// Expected: XXH3_128bits() of libxxhash 0.8.1, the compiled library.
TEST(ContentHash, IsXxh128) {
    EXPECT_EQ(hash_of(""), "99aa06d3014798d86001c324468d497f");
    EXPECT_EQ(hash_of("abc"), "06b05ab6733a618578af5f94892f3950");
    EXPECT_EQ(hash_of(std::string(1000, 'x')), "50a1af5a5f2dcf01c0a4877b962cba82");
}

TEST(ContentHash, PiecesDoNotMatter) {
    const std::string text(3000, 'e');
    for (const std::size_t piece : {1u, 7u, 256u, 1024u, 2999u}) {
        ContentHash hash;
        for (std::size_t at = 0; at < text.size(); at += piece) hash.add(std::string_view(text).substr(at, piece));
        hash.add(std::string_view{});
        EXPECT_EQ(hash.hex(), hash_of(text)) << piece;
        EXPECT_EQ(hash.hex().size(), ContentHash::kHexDigits);
    }
}

TEST(ContentHash, EveryBitCounts) {
    std::string text(300, 'e');
    const std::string whole = hash_of(text);
    for (char& c : text) {
        for (int bit = 0; bit < 8; ++bit) {
            c = static_cast<char>(c ^ (1 << bit));
            EXPECT_NE(hash_of(text), whole);
            c = static_cast<char>(c ^ (1 << bit));
        }
    }
}

}  // namespace
}  // namespace emulsion
