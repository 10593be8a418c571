#pragma once
// The chunks of a PNG, by the format and not by libpng.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace emulsion {

inline std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char c : bytes.substr(0, 4)) value = (value << 8u) | static_cast<unsigned char>(c);
    return value;
}

struct Chunk {
    std::string type, data;
};

/// The chunks of a PNG file in their order.
inline std::vector<Chunk> chunks_of(const std::string& png) {
    std::vector<Chunk> chunks;
    std::size_t at = 8;
    while (at + 12 <= png.size()) {
        const std::size_t length = big_endian(std::string_view(png).substr(at));
        chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, length)});
        at += 12 + length;
    }
    EXPECT_EQ(at, png.size());
    return chunks;
}

inline std::string data_of(const std::vector<Chunk>& chunks, std::string_view type) {
    const auto found = std::find_if(chunks.begin(), chunks.end(), [&](const Chunk& c) { return c.type == type; });
    return found == chunks.end() ? "no such chunk" : found->data;
}

}  // namespace emulsion
