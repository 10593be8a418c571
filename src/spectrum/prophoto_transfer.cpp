#include "spectrum/prophoto_transfer.h"

#include <cmath>

#include "spectrum/odd_extension.h"

namespace emulsion {

namespace {

constexpr double kExponent = ProPhotoTransfer::kExponent;

}  // namespace

double encode(const ProPhotoTransfer& transfer, double linear) noexcept {
    return odd(linear, [&](double x) noexcept {
        return x < ProPhotoTransfer::kLinearKnee ? ProPhotoTransfer::kSlope * x : encode_above_knee(transfer, x);
    });
}

double decode(const ProPhotoTransfer& /*transfer*/, double encoded) noexcept {
    return odd(encoded, [](double v) noexcept {
        return v < ProPhotoTransfer::kEncodedKnee ? v / ProPhotoTransfer::kSlope : std::pow(v, kExponent);
    });
}

double encode_above_knee(const ProPhotoTransfer& /*transfer*/, double linear) noexcept {
    return std::pow(linear, 1.0 / kExponent);
}

}  // namespace emulsion
