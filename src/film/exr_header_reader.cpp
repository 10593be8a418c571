#include "film/exr_header_reader.h"

#include <cerrno>
#include <system_error>

#include "core/error.h"

namespace emulsion {

HeaderReader::HeaderReader(const std::filesystem::path& path) : path_(path) {
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

std::uint32_t word(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return value;
}

std::int64_t signed_word(std::string_view bytes, std::size_t at) { return static_cast<std::int32_t>(word(bytes, at)); }

}  // namespace emulsion
