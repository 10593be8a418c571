#pragma once
// No transfer function: encoded values are the linear ones.

#include <string_view>

namespace emulsion {

struct LinearTransfer {
    static constexpr std::string_view kName = "linear";
    static constexpr std::string_view kHelp = "none, codes are proportional to light";
    bool operator==(const LinearTransfer&) const = default;
};

[[nodiscard]] inline double encode(const LinearTransfer& /*transfer*/, double linear) noexcept { return linear; }
[[nodiscard]] inline double decode(const LinearTransfer& /*transfer*/, double encoded) noexcept { return encoded; }

}  // namespace emulsion
