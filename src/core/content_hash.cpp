#include "core/content_hash.h"

#include <cstddef>

#include <fmt/format.h>

#include "core/random.h"

namespace emulsion {

namespace {

/// Up to 8 bytes, the first lowest, whatever the machine's own order.
std::uint64_t word_of(std::string_view bytes) noexcept {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        word |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    }
    return word;
}

}  // namespace

void ContentHash::add(std::string_view bytes) noexcept {
    add_word(bytes.size());
    for (; bytes.size() >= 8; bytes.remove_prefix(8)) add_word(word_of(bytes.substr(0, 8)));
    if (!bytes.empty()) add_word(word_of(bytes));
}

std::string ContentHash::digits() const { return fmt::format("{:016x}{:016x}", a_, b_); }

void ContentHash::add_word(std::uint64_t word) noexcept {
    a_ = hash_combine(a_, word);
    b_ = hash_combine(b_, word);
}

}  // namespace emulsion
