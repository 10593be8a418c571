#include "pathtracer/image_file_check.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "core/error.h"

namespace emulsion {

namespace {

/// Reads a file's bytes in order; past their end it throws.
class Bytes {
  public:
    Bytes(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw IoError(path_, fmt::format("byte {}: found {}, expected {}", at_, found, expected));
    }
    [[nodiscard]] std::string_view take(std::size_t count) {
        if (count > bytes_.size() - at_) {
            fail(fmt::format("the end of the file in {} bytes", bytes_.size() - at_), fmt::format("{} more", count));
        }
        at_ += count;
        return bytes_.substr(at_ - count, count);
    }
    [[nodiscard]] unsigned byte() { return static_cast<unsigned char>(take(1).front()); }
    /// The most significant byte first.
    [[nodiscard]] std::uint32_t number(int bytes) {
        std::uint32_t value = 0;
        for (int i = 0; i < bytes; ++i) value = value << 8u | byte();
        return value;
    }

  private:
    const std::filesystem::path& path_;
    std::string_view bytes_;
    std::size_t at_ = 0;
};

/// The cyclic redundancy check of ISO 3309 of one byte value, by which a table goes through whole bytes.
constexpr std::array<std::uint32_t, 256> crc_table() noexcept {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t crc = i;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1u) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
        table[i] = crc;
    }
    return table;
}

std::uint32_t crc_of(std::string_view first, std::string_view second) noexcept {
    static constexpr std::array<std::uint32_t, 256> kTable = crc_table();
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const std::string_view part : {first, second}) {
        for (const char c : part) crc = kTable[(crc ^ static_cast<unsigned char>(c)) & 0xFFu] ^ (crc >> 8u);
    }
    return ~crc;
}

/// The tables of one segment.
void check_huffman_tables(Bytes& file, std::uint32_t length) {
    constexpr std::uint32_t kHead = 17;
    while (length > 0) {
        if (length < kHead) file.fail("a piece of a Huffman table", "a whole one");
        static_cast<void>(file.byte());  // its class and number
        std::uint32_t codes = 0;
        for (std::uint32_t i = 1; i < kHead; ++i) codes += file.byte();
        if (codes > 256 || codes > length - kHead) {
            file.fail(fmt::format("a Huffman table of {} codes", codes),
                      fmt::format("at most {}", std::min<std::uint32_t>(256, length - kHead)));
        }
        static_cast<void>(file.take(codes));
        length -= kHead + codes;
    }
}

/// Over the coded data of a scan to the next marker, whose second byte this returns.
unsigned skip_scan(Bytes& file) {
    while (true) {
        if (file.byte() != 0xFF) continue;
        unsigned marker = file.byte();
        while (marker == 0xFF) marker = file.byte();
        const bool restart = marker >= 0xD0 && marker <= 0xD7;
        if (marker != 0 && !restart) return marker;
    }
}

unsigned next_marker(Bytes& file) {
    const unsigned first = file.byte();
    if (first != 0xFF) file.fail(fmt::format("{:#04x}", first), "a JPEG marker");
    unsigned marker = file.byte();
    while (marker == 0xFF) marker = file.byte();
    return marker;
}

}  // namespace

void check_png(const std::filesystem::path& path, std::string_view bytes) {
    using namespace std::string_view_literals;
    Bytes file(path, bytes);
    if (!bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) file.fail("another signature", "that of a PNG picture");
    static_cast<void>(file.take(8));
    std::string_view type;
    while (type != "IEND") {
        const std::uint32_t length = file.number(4);
        type = file.take(4);
        const std::string_view data = file.take(length);
        if (file.number(4) != crc_of(type, data)) file.fail("a chunk with another check sum", "that of its bytes");
    }
}

void check_jpeg(const std::filesystem::path& path, std::string_view bytes) {
    constexpr unsigned kStart = 0xD8, kEnd = 0xD9, kScan = 0xDA, kHuffmanTables = 0xC4;
    Bytes file(path, bytes);
    if (!bytes.starts_with("\xFF\xD8")) file.fail("another signature", "that of a JPEG picture");
    unsigned marker = next_marker(file);
    while (marker != kEnd) {
        const bool alone = marker == kStart || marker == 0x01 || (marker >= 0xD0 && marker <= 0xD7);
        if (!alone) {
            const std::uint32_t length = file.number(2);
            if (length < 2) file.fail(fmt::format("a segment of {} bytes", length), "at least 2");
            if (marker == kHuffmanTables) {
                check_huffman_tables(file, length - 2);
            } else {
                static_cast<void>(file.take(length - 2));
            }
        }
        marker = marker == kScan ? skip_scan(file) : next_marker(file);
    }
}

}  // namespace emulsion
