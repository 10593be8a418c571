#include "film/exr_header_check.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

#include "core/error.h"

namespace emulsion {

namespace {

/// Reads forward through a file of known size; every failure is an IoError.
class HeaderReader {
  public:
    explicit HeaderReader(const std::filesystem::path& path) : path_(path) {
        std::error_code error;
        const auto status = std::filesystem::status(path, error);
        if (!std::filesystem::exists(status)) fail(error ? error.message() : "no such file");
        if (std::filesystem::is_directory(status)) fail("is a folder, expected an EXR file");
        if (!std::filesystem::is_regular_file(status)) fail("is not a regular file, expected an EXR file");
        remaining_ = size_ = std::filesystem::file_size(path, error);
        if (error) fail(error.message());
        if (size_ == 0) fail("is empty, expected an EXR file");
        errno = 0;
        stream_.open(path, std::ios::binary);
        if (!stream_) fail("cannot open: " + errno_text(errno));
    }

    [[nodiscard]] std::uint64_t file_size() const noexcept { return size_; }
    [[noreturn]] void fail(const std::string& reason) const { throw IoError(path_, reason); }

    std::string bytes(std::uint64_t count) {
        if (count > remaining_) fail("is cut off in its header");
        std::string text(static_cast<std::size_t>(count), '\0');
        stream_.read(text.data(), static_cast<std::streamsize>(count));
        if (!stream_) fail("cannot read its header");
        remaining_ -= count;
        return text;
    }

    /// Text up to a zero byte; at most 255 characters, as the format has it.
    std::string name() {
        std::string text;
        for (;;) {
            const char next = bytes(1)[0];
            if (next == '\0') return text;
            text += next;
            if (text.size() > 255) fail("is not a valid EXR: a name in its header has more than 255 characters");
        }
    }

  private:
    std::filesystem::path path_;
    std::ifstream stream_;
    std::uint64_t size_ = 0, remaining_ = 0;
};

/// The 32-bit little-endian number at a place of some bytes.
std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return value;
}

std::int64_t signed_word(std::string_view bytes, std::size_t at) { return static_cast<std::int32_t>(word(bytes, at)); }

struct HeaderFacts {
    bool has_window = false, has_channels = false;
    std::int64_t width = 0, height = 0;
    std::int64_t bytes_per_pixel = 0;  // of all channels, as if none were subsampled
    int compression = 0;
    std::uint64_t tile_width = 0, tile_height = 0;
};

/// What a file of `size` bytes can expand to. Deflate makes at most 1032 bytes of one, PIZ and RLE less, PXR24 4/3 of
/// it; the two of DWA run-length code before they deflate.
std::uint64_t largest_expansion(std::uint64_t size, int compression) {
    constexpr int kNone = 0, kDwaa = 8;
    if (compression == kNone) return size;
    return size * (compression >= kDwaa ? std::uint64_t{1} << 17u : 2048u);
}

std::int64_t bytes_per_pixel_of(const HeaderReader& file, std::string_view channels) {
    // name, zero, pixel type (0 uint, 1 half, 2 float), 4 bytes of no interest here, x and y sampling; at the end a
    // zero.
    std::int64_t bytes = 0;
    std::size_t at = 0;
    while (at < channels.size() && channels[at] != '\0') {
        const std::size_t end_of_name = channels.find('\0', at);
        if (end_of_name == std::string_view::npos || channels.size() - end_of_name < 17) {
            file.fail("is not a valid EXR: its list of channels is cut off");
        }
        bytes += word(channels, end_of_name + 1) == 1 ? 2 : 4;
        at = end_of_name + 17;
    }
    return bytes;
}

void note_attribute(const HeaderReader& file, std::string_view name, std::string_view type, std::string_view value,
                    HeaderFacts& facts) {
    if (name == "dataWindow" && type == "box2i" && value.size() == 16) {
        facts.width = signed_word(value, 8) - signed_word(value, 0) + 1;
        facts.height = signed_word(value, 12) - signed_word(value, 4) + 1;
        facts.has_window = true;
    } else if (name == "channels" && type == "chlist") {
        facts.bytes_per_pixel = bytes_per_pixel_of(file, value);
        facts.has_channels = true;
    } else if (name == "compression" && type == "compression" && value.size() == 1) {
        facts.compression = static_cast<unsigned char>(value[0]);
    } else if (name == "tiles" && type == "tiledesc" && value.size() == 9) {
        facts.tile_width = word(value, 0);
        facts.tile_height = word(value, 4);
    }
}

void check_version(HeaderReader& file) {
    constexpr std::uint32_t kMagic = 20000630, kDeep = 0x800, kMultiPart = 0x1000;
    const std::string magic = file.file_size() < 8 ? std::string(4, '\0') : file.bytes(4);
    if (word(magic, 0) != kMagic) file.fail("is not an EXR file");
    const std::uint32_t version = word(file.bytes(4), 0);
    if ((version & 0xffu) != 2) {
        file.fail("is an EXR of version " + std::to_string(version & 0xffu) + ", expected 2");
    }
    if (version & kMultiPart) file.fail("is an EXR of several parts, expected a single one");
    if (version & kDeep) file.fail("is a deep EXR, expected a flat one");
}

void check_sizes(const HeaderReader& file, const HeaderFacts& facts) {
    if (!facts.has_window) file.fail("is not a valid EXR: its header has no dataWindow");
    if (!facts.has_channels) file.fail("is not a valid EXR: its header has no channels");
    const std::string size = std::to_string(facts.width) + "x" + std::to_string(facts.height);
    if (facts.width < 1 || facts.height < 1) file.fail("is not a valid EXR: its data window is " + size + " pixels");

    // OpenEXR's own limit for coordinates is 2^30; the product then fits, and the third factor goes to the other side.
    constexpr std::int64_t kMost = std::int64_t{1} << 31u;
    if (facts.width > kMost || facts.height > kMost)
        file.fail("is not a valid EXR: its data window is " + size + " pixels");
    const std::uint64_t pixels = static_cast<std::uint64_t>(facts.width) * static_cast<std::uint64_t>(facts.height);
    const std::uint64_t bytes = largest_expansion(file.file_size(), facts.compression);
    if (pixels > bytes / static_cast<std::uint64_t>(std::max<std::int64_t>(facts.bytes_per_pixel, 1))) {
        file.fail("is damaged or incomplete: its header promises " + size + " pixels, too many for " +
                  std::to_string(file.file_size()) + " bytes");
    }
    constexpr std::uint64_t kUsualTile = 4096;
    if (facts.tile_width > std::max<std::uint64_t>(kUsualTile, static_cast<std::uint64_t>(facts.width)) ||
        facts.tile_height > std::max<std::uint64_t>(kUsualTile, static_cast<std::uint64_t>(facts.height))) {
        file.fail("is not a valid EXR: its tiles have " + std::to_string(facts.tile_width) + "x" +
                  std::to_string(facts.tile_height) + " pixels, and the picture " + size);
    }
}

}  // namespace

void check_exr_header(const std::filesystem::path& path) {
    HeaderReader file(path);
    check_version(file);
    HeaderFacts facts;
    for (std::string name = file.name(); !name.empty(); name = file.name()) {
        const std::string type = file.name();
        const std::uint32_t size = word(file.bytes(4), 0);
        note_attribute(file, name, type, file.bytes(size), facts);
    }
    check_sizes(file, facts);
}

}  // namespace emulsion
