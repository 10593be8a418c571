#include "display/transfer_encoder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace emulsion {

namespace {

using AnyEncoder = std::variant<IdentityEncoder, StraightToeCurve, SquareRootToeCurve, ExactEncoder<GammaTransfer>,
                                ExactEncoder<TableTransfer>>;

/// The least normal float: the table's segments widen to octaves and more below it.
constexpr float kLeastFloat = std::numeric_limits<float>::min();

/// A type whose header has a straight piece up to kLinearKnee, and another function above.
template <class T>
concept HasStraightToe = requires {
    T::kSlope;
};

/// The greatest float that is not above the knee, so that each float gets the piece that its exact value belongs to.
float last_float_of_toe(double knee) noexcept {
    const auto nearest = static_cast<float>(knee);
    return static_cast<double>(nearest) <= knee ? nearest : std::nextafter(nearest, 0.0f);
}

/// Curves without a knee: the table down to the least normal float, below it what 0 has: 2.6e-8 off at the most, for
/// gamma 5.
template <class Curve>
AnyEncoder encoder_of_curve(const Curve& curve) {
    const float last = std::nextafter(kLeastFloat, 0.0f);
    return StraightToeCurve{last, 0.0f, static_cast<float>(curve(0.0)), CurveTable(curve, kLeastFloat)};
}

template <class T>
AnyEncoder encoder_of(const T& transfer) {
    return encoder_of_curve([&](double x) { return encode(transfer, x); });
}

template <HasStraightToe T>
AnyEncoder encoder_of(const T& transfer) {
    const float last = last_float_of_toe(T::kLinearKnee);
    const auto curve = [&](double x) { return encode_above_knee(transfer, x); };
    return StraightToeCurve{last, static_cast<float>(T::kSlope), 0.0f, CurveTable(curve, last)};
}

AnyEncoder encoder_of(const LinearTransfer& /*transfer*/) { return IdentityEncoder{}; }

AnyEncoder encoder_of(const GammaTransfer& transfer) {
    if (transfer.exponent < 1.0) return ExactEncoder<GammaTransfer>{transfer};
    return encoder_of<GammaTransfer>(transfer);
}

AnyEncoder encoder_of_shown(const Bt1886Transfer& transfer, const DisplayLight& light) {
    const auto curve = [&](double x) { return encode(transfer, shown_share(light, x)); };
    const double dark = shown_share(light, 0.0);
    const double knee = (decode(transfer, 0.0) - dark) / (1.0 - dark);
    const float last = last_float_of_toe(std::max(knee, 0.0));
    if (last < kLeastFloat) return encoder_of_curve(curve);
    return StraightToeCurve{last, 0.0f, 0.0f, CurveTable(curve, last)};
}

AnyEncoder encoder_of(const Bt1886Transfer& transfer) { return encoder_of_shown(transfer, {.black_cdm2 = 0.0}); }

AnyEncoder encoder_of(const TableTransfer& transfer) { return ExactEncoder<TableTransfer>{transfer}; }

AnyEncoder encoder_of(const HlgTransfer& transfer) {
    const float last = last_float_of_toe(HlgTransfer::kLinearKnee);
    const auto curve = [&](double x) { return encode_above_knee(transfer, x); };
    return SquareRootToeCurve{last, CurveTable(curve, last)};
}

void encode_all(const IdentityEncoder& /*encoder*/, std::span<RGB> /*linear*/) noexcept {}

/// As one row of components.
template <class Curve>
void encode_all(const Curve& curve, std::span<RGB> linear) noexcept {
    if (!linear.empty()) encode_row(curve, {&linear.data()->r, 3 * linear.size()});
}

template <class Transfer>
void encode_all(const ExactEncoder<Transfer>& encoder, std::span<RGB> linear) noexcept {
    const auto encoded = [&](float x) noexcept {
        return static_cast<float>(encode(encoder.transfer, static_cast<double>(x)));
    };
    for (RGB& rgb : linear) rgb = {encoded(rgb.r), encoded(rgb.g), encoded(rgb.b)};
}

}  // namespace

TransferEncoder::TransferEncoder(const TransferFunction& transfer) {
    validate_named(transfer, "transfer");
    encoder_ = std::visit([](const auto& chosen) { return encoder_of(chosen); }, transfer);
}

TransferEncoder::TransferEncoder(const PqTransfer& transfer, const DisplayLight& light)
    : encoder_(encoder_of_curve([&](double x) { return encode(transfer, pq_linear(light, x)); })) {}

TransferEncoder::TransferEncoder(const Bt1886Transfer& transfer, const DisplayLight& light)
    : encoder_(encoder_of_shown(transfer, light)) {}

void TransferEncoder::operator()(std::span<RGB> linear) const noexcept {
    visit_noexcept([&](const auto& encoder) { encode_all(encoder, linear); }, encoder_);
}

}  // namespace emulsion
