#include "spectrum/hlg.h"

#include <cmath>

#include "spectrum/odd_extension.h"

namespace emulsion {

namespace {

constexpr double kA = 0.17883277;
constexpr double kB = 1.0 - 4.0 * kA;

}  // namespace

double encode(const HlgTransfer& transfer, double linear) noexcept {
    return odd(linear, [&](double x) noexcept {
        return x <= HlgTransfer::kLinearKnee ? std::sqrt(3.0 * x) : encode_above_knee(transfer, x);
    });
}

double decode(const HlgTransfer& /*transfer*/, double encoded) noexcept {
    return odd(encoded, [](double v) noexcept {
        if (v <= HlgTransfer::kEncodedKnee) return v * v / 3.0;
        return (4.0 * kA * std::exp((v - 0.5) / kA) + kB) / 12.0;
    });
}

// a ln(12 x - b) + c with c = 0.5 - a ln(4a), which joins the logarithms.
double encode_above_knee(const HlgTransfer& /*transfer*/, double linear) noexcept {
    return 0.5 + kA * std::log((12.0 * linear - kB) / (4.0 * kA));
}

}  // namespace emulsion
