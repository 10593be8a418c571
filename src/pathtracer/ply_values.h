#pragma once
// The values of a PLY file one after the other, whichever way they are stored.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "pathtracer/ply_header.h"

namespace emulsion {

/// Every member throws IoError naming the path and the line (of text) or the byte (of binary) at which the file is
/// wrong.
class PlyValues {
  public:
    PlyValues(const std::filesystem::path& path, std::string_view bytes, const PlyHeader& header)
        : path_(path), bytes_(bytes), format_(header.format), offset_(header.body_offset) {}

    /// The next value; not finite if the file says so.
    [[nodiscard]] double next(PlyType type);
    /// The length of a list.
    [[nodiscard]] std::uint64_t next_count(PlyType type);
    void skip(PlyType type, std::uint64_t values);
    void skip(const PlyProperty& property);
    /// All of an element.
    void skip(const PlyElement& element);

    /// \throws unless what is left of the file can hold all of the element.
    void check_room_for(const PlyElement& element) const;
    /// Bytes of the file that are left.
    [[nodiscard]] std::size_t room() const noexcept { return bytes_.size() - offset_; }

    /// Says where the value stands that was read last.
    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

  private:
    [[nodiscard]] double next_of_text();
    [[nodiscard]] std::string_view take(std::size_t count);

    const std::filesystem::path& path_;
    std::string_view bytes_;
    PlyFormat format_;
    std::size_t offset_;
    std::size_t last_ = 0;  // where the last value began
};

}  // namespace emulsion
