#pragma once
// A fingerprint of bytes: 128 bits, quick, the same on every machine. It tells whether two contents are the same and
// whether one was damaged; against somebody who wants to deceive it is no protection.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace emulsion {

/// XXH3 in its 128-bit form, of bytes that come piece by piece; how they are cut into pieces does not matter.
/// Source: Y. Collet, "xxHash fast digest algorithm", XXH3_128bits, seed 0.
class ContentHash {
  public:
    static constexpr std::size_t kHexDigits = 32;

    ContentHash();
    ~ContentHash();
    ContentHash(const ContentHash&) = delete;
    ContentHash& operator=(const ContentHash&) = delete;

    void add(std::span<const std::byte> bytes) noexcept;
    void add(std::string_view text) noexcept { add(std::as_bytes(std::span(text))); }

    /// Of all that was added so far: kHexDigits hexadecimal digits in small letters, as `xxh128sum` prints them.
    [[nodiscard]] std::string hex() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace emulsion
