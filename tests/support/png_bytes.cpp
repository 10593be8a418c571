#include "support/png_bytes.h"

#include <algorithm>

namespace emulsion::testing {

namespace {

std::string big_endian(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xFFu);
    return text;
}

/// ISO 3309, bit by bit.
std::uint32_t crc(std::string_view bytes) {
    std::uint32_t rest = 0xFFFFFFFFu;
    for (const char c : bytes) {
        rest ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1) ^ ((rest & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    return ~rest;
}

/// RFC 1950, in stored blocks.
std::string zlib_stored(std::string_view bytes) {
    std::string text = "\x78\x01";
    std::uint32_t a = 1, b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    do {
        const std::size_t count = std::min<std::size_t>(bytes.size(), 65535);
        const std::string length = big_endian(static_cast<std::uint32_t>(count), 2);
        text += count == bytes.size() ? '\1' : '\0';
        text += {length[1], length[0], static_cast<char>(~length[1]), static_cast<char>(~length[0])};
        text += bytes.substr(0, count);
        bytes.remove_prefix(count);
    } while (!bytes.empty());
    return text + big_endian(b << 16 | a, 4);
}

}  // namespace

std::string png_chunk(std::string_view type, std::string_view data) {
    const std::string named = std::string(type) + std::string(data);
    return big_endian(static_cast<std::uint32_t>(data.size()), 4) + named + big_endian(crc(named), 4);
}

std::string png_bytes(const PngFormat& format, std::span<const int> codes) {
    std::string header = big_endian(format.width, 4) + big_endian(format.height, 4);
    header += {static_cast<char>(format.bits), static_cast<char>(format.colour_type), '\0', '\0', '\0'};
    std::string rows;
    const std::size_t components = format.colour_type == 2   ? 3
                                   : format.colour_type == 4 ? 2
                                   : format.colour_type == 6 ? 4
                                                             : 1;
    const std::size_t per_row = components * format.width;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        if (i == 0 || (per_row > 0 && i % per_row == 0)) rows += '\0';  // no filter
        rows += big_endian(static_cast<std::uint32_t>(codes[i]), format.bits / 8);
    }
    std::string file = "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header);
    if (!format.palette.empty()) file += png_chunk("PLTE", format.palette);
    return file + png_chunk("IDAT", zlib_stored(rows)) + png_chunk("IEND", "");
}

}  // namespace emulsion::testing
