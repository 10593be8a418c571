#include "film/exr_header_reader.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace emulsion {

HeaderReader::HeaderReader(const std::filesystem::path& path) : path_(path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) fail(error ? error.message() : errno_text(ENOENT));
    if (std::filesystem::is_directory(status)) fail("is a folder, expected an EXR file");
    if (!std::filesystem::is_regular_file(status)) fail("is not a regular file, expected an EXR file");
    errno = 0;
    stream_.open(path, std::ios::binary);
    if (!stream_) fail("cannot open: " + errno_text(errno));
    // The size of the file that was opened: by now another one may have been renamed over its name.
    stream_.seekg(0, std::ios::end);
    const std::streamoff size = stream_.tellg();
    stream_.seekg(0);
    if (!stream_ || size < 0) fail("cannot read: " + errno_text(errno));
    remaining_ = size_ = static_cast<std::uint64_t>(size);
    if (size_ == 0) fail("is empty, expected an EXR file");
}

void HeaderReader::fail(const std::string& reason) const { throw IoError(path_, reason); }

std::string HeaderReader::bytes(std::uint64_t count) {
    if (count > remaining_) fail("is cut off in its header");
    std::string text(static_cast<std::size_t>(count), '\0');
    stream_.read(text.data(), static_cast<std::streamsize>(count));
    if (!stream_) fail("cannot read its header");
    remaining_ -= count;
    return text;
}

std::string HeaderReader::name() {
    std::string text;
    for (;;) {
        const char next = bytes(1)[0];
        if (next == '\0') return text;
        text += next;
        if (text.size() > 255) fail("is not a valid EXR: a name in its header has more than 255 characters");
    }
}

bool read_exr_version(HeaderReader& file) {
    constexpr std::uint32_t kMagic = 20000630, kDeep = 0x800, kMultiPart = 0x1000;
    const std::string magic = file.file_size() < 8 ? std::string(4, '\0') : file.bytes(4);
    if (word(magic, 0) != kMagic) file.fail("is not an EXR file");
    const std::uint32_t version = word(file.bytes(4), 0);
    if ((version & 0xffu) != 2) {
        file.fail("is an EXR of version " + std::to_string(version & 0xffu) + ", expected 2");
    }
    if (version & kDeep) file.fail("is a deep EXR, expected a flat one");
    return (version & kMultiPart) != 0;
}

bool read_attribute(HeaderReader& file, RawAttribute& attribute) {
    std::string name = file.name();
    if (name.empty()) return false;
    attribute.name = std::move(name);
    attribute.type = file.name();
    const std::uint32_t size = word(file.bytes(4), 0);
    attribute.value_position = file.position();
    attribute.value = file.bytes(size);
    return true;
}

std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return value;
}

std::int64_t signed_word(std::string_view bytes, std::size_t at) { return static_cast<std::int32_t>(word(bytes, at)); }

}  // namespace emulsion
