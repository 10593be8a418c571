#pragma once
// Transfer functions ("gamma"): between linear RGB, proportional to light, and encoded RGB, even steps of which look
// about even. Both in [0, 1], 0 and 1 fixed.

#include <span>
#include <variant>

#include "core/color.h"
#include "core/named_value.h"
#include "display/srgb_transfer.h"

namespace emulsion {

/// All transfer functions; the first is the default.
using TransferFunction = std::variant<SrgbTransfer>;

/// The specification, in double precision. Argument in [0, 1].
[[nodiscard]] inline double encode(const TransferFunction& transfer, double linear) noexcept {
    return visit_noexcept([&](const auto& chosen) { return encode(chosen, linear); }, transfer);
}
[[nodiscard]] inline double decode(const TransferFunction& transfer, double encoded) noexcept {
    return visit_noexcept([&](const auto& chosen) { return decode(chosen, encoded); }, transfer);
}

/// In place, single precision; each function's header states the tolerance to the specification. Components in [0, 1].
inline void encode(const TransferFunction& transfer, std::span<RGB> linear) noexcept {
    visit_noexcept([&](const auto& chosen) { encode(chosen, linear); }, transfer);
}

}  // namespace emulsion
