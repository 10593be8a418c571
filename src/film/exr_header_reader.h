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
    [[noreturn]] void fail(const std::string& reason) const;

    [[nodiscard]] std::string bytes(std::uint64_t count);
    /// Text up to a zero byte; at most 255 characters, as the format has it.
    [[nodiscard]] std::string name();

  private:
    std::filesystem::path path_;
    std::ifstream stream_;
    std::uint64_t size_ = 0, remaining_ = 0;
};

/// The 32-bit little-endian number at a place of some bytes, which must reach that far.
[[nodiscard]] std::uint32_t word(std::string_view bytes, std::size_t at);
[[nodiscard]] std::int64_t signed_word(std::string_view bytes, std::size_t at);

}  // namespace emulsion
