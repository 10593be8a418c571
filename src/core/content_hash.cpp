#include "core/content_hash.h"

#include <fmt/format.h>

#define XXH_INLINE_ALL  // the header alone: nothing is linked
#include <xxhash.h>

namespace emulsion {

struct ContentHash::State {
    XXH3_state_t xxh3;
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->xxh3); }

ContentHash::~ContentHash() = default;

void ContentHash::add(std::span<const std::byte> bytes) noexcept {
    if (!bytes.empty()) XXH3_128bits_update(&state_->xxh3, bytes.data(), bytes.size());
}

std::string ContentHash::hex() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(&state_->xxh3);
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace emulsion
