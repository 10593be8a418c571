#pragma once
// The display curve of standard television. For "linear" and "encoded" see spectrum/transfer_function.h.

#include <array>
#include <string_view>

#include "core/parameters.h"

namespace emulsion {

/// decode(v) = a max(v + b, 0)^2.4 / white with a = (white^(1/2.4) - black^(1/2.4))^2.4 and
/// b = black^(1/2.4) / (white^(1/2.4) - black^(1/2.4)): code 0 shows black, code 1 white, linear is the luminance over
/// that of white. With the default black of 0 it is the pure power 2.4, and white doesn't matter.
/// Source: ITU-R BT.1886 (2011), annex 1. Outside [0, 1] the formula goes on, up to codes below -b: there the standard
/// has 0, and ours is odd about -b, so that it has an inverse for every value. Light below black has negative codes.
struct Bt1886Transfer {
    static constexpr std::string_view kName = "bt1886";
    static constexpr std::string_view kHelp = "display curve of BT.1886, a power of 2.4 above its black";
    static constexpr double kExponent = 2.4;  ///< of decoding
    double black_cdm2 = 0.0;                  ///< in [0, 5]
    double white_cdm2 = 100.0;                ///< in [10, 10000]
    bool operator==(const Bt1886Transfer&) const = default;

    static constexpr std::array kParameters = {
        Parameter<Bt1886Transfer>{"black", &Bt1886Transfer::black_cdm2, {0.0, 5.0}, "cd/m^2", "luminance of code 0"},
        Parameter<Bt1886Transfer>{
            "white", &Bt1886Transfer::white_cdm2, {10.0, 10000.0}, "cd/m^2", "luminance of code 1"}};
};

[[nodiscard]] double encode(const Bt1886Transfer& transfer, double linear) noexcept;
[[nodiscard]] double decode(const Bt1886Transfer& transfer, double encoded) noexcept;

}  // namespace emulsion
