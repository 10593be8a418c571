#pragma once
// A pure power. For "linear", "encoded" and values outside [0, 1] see spectrum/transfer_function.h.

#include <array>
#include <string_view>

#include "core/parameters.h"

namespace emulsion {

/// encode(x) = x^(1/exponent), decode(v) = v^exponent: a display of "gamma 2.2". Its slope at 0 is infinite for
/// exponents above 1. DCI-P3 is exponent 2.6 (SMPTE RP 431-2), Apple's old displays 1.8, NTSC and Adobe about 2.2.
struct GammaTransfer {
    static constexpr std::string_view kName = "gamma";
    static constexpr std::string_view kHelp = "a pure power";
    double exponent = 2.2;  ///< of decoding; in [0.1, 5]
    bool operator==(const GammaTransfer&) const = default;

    static constexpr std::array kParameters = {
        Parameter<GammaTransfer>{"exponent", &GammaTransfer::exponent, {0.1, 5.0}, "", "light is the code to this"}};
};

[[nodiscard]] double encode(const GammaTransfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const GammaTransfer& transfer, double encoded) noexcept;

}  // namespace emulsion
