#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace emulsion {

/// Reads forward through an EXR file of known size; every failure is an IoError.
class HeaderReader {
  public:
    /// \throws IoError if the file is missing, not a regular file, empty, or cannot be opened.
    explicit HeaderReader(const std::filesystem::path& path);

    [[nodiscard]] std::uint64_t file_size() const noexcept { return size_; }
    /// The place of the byte that comes next.
    [[nodiscard]] std::uint64_t position() const noexcept { return size_ - remaining_; }
    /// The file itself, for going on with it by other means; this object then is of no further use.
    [[nodiscard]] std::ifstream& stream() noexcept { return stream_; }
    [[noreturn]] void fail(const std::string& reason) const;

    [[nodiscard]] std::string bytes(std::uint64_t count);
    /// Text up to a zero byte; at most 255 characters, as the format has it.
    [[nodiscard]] std::string name();

  private:
    std::filesystem::path path_;
    std::ifstream stream_;
    std::uint64_t size_ = 0, remaining_ = 0;
};

/// An attribute as it lies in the file.
struct RawAttribute {
    std::string name, type, value;
    std::uint64_t value_position = 0;  ///< of the value's first byte
};

/// Reads the magic number and the version; the attributes of the first part come next.
/// \returns whether the file has several parts. \throws IoError if it is no EXR of flat pictures that we know.
[[nodiscard]] bool read_exr_version(HeaderReader& file);

/// Reads an attribute; false, with no change, at the end of a part's header. \throws IoError.
[[nodiscard]] bool read_attribute(HeaderReader& file, RawAttribute& attribute);

/// The 32-bit little-endian number at a place of some bytes, which must reach that far.
[[nodiscard]] std::uint32_t word(std::string_view bytes, std::size_t at);
[[nodiscard]] std::int64_t signed_word(std::string_view bytes, std::size_t at);

}  // namespace emulsion
