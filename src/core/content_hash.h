#pragma once
// Telling contents apart: 128 bits of everything that was added, in its order. Not against forgers: whoever wants two
// contents with one hash will find them.

#include <cstdint>
#include <string>
#include <string_view>

namespace emulsion {

/// The same on every machine, and part of files: changing it makes old ones strangers.
class ContentHash {
  public:
    /// One piece of content. Where a piece ends counts: "ab" and "c" are not "a" and "bc".
    void add(std::string_view bytes) noexcept;

    /// 32 hexadecimal digits of all pieces so far.
    [[nodiscard]] std::string digits() const;

  private:
    void add_word(std::uint64_t word) noexcept;

    // Two hashes of the same words from different starts. Any two will do; these are digits of pi, which hide nothing.
    std::uint64_t a_ = 0x243f6a8885a308d3u, b_ = 0x13198a2e03707344u;
};

}  // namespace emulsion
