#pragma once
// Transfer functions for pictures: linear RGB in [0, 1] to encoded RGB in [0, 1], in single precision. What the
// functions are is said, and specified in double precision, in spectrum/transfer_function.h.

#include <span>
#include <variant>

#include "core/color.h"
#include "display/display_light.h"
#include "display/encode_rows.h"
#include "spectrum/transfer_function.h"

namespace emulsion {

/// Linear values as they are.
struct IdentityEncoder {};

/// The specification itself, of functions that parabolas don't fit: gammas below 1, which are steep near 1, where the
/// segments of the table are widest, and measured tables with their kinks.
template <class Transfer>
struct ExactEncoder {
    Transfer transfer;
};

/// What PQ takes for the linear signal x in [0, 1] of a display: (black + x (peak - black)) / 10000 cd/m^2.
[[nodiscard]] constexpr double pq_linear(const DisplayLight& light, double x) noexcept {
    return (light.black_cdm2 + x * (light.peak_cdm2 - light.black_cdm2)) / PqTransfer::kPeak_cdm2;
}

/// One transfer function, made ready for pictures: this costs about a millisecond. Within 6.4e-8 of the specification
/// (0.0042 of a 16-bit code), 1 exactly to itself, 0 to what the specification has there, rising but for the steps that
/// the specification has at its knees: measured over floats of all sizes down to 0, and every one next to the table's
/// joins. Light below the black of BT.1886, which would have negative codes, gets 0.
class TransferEncoder {
  public:
    /// \throws std::invalid_argument naming the parameter that is out of its range.
    explicit TransferEncoder(const TransferFunction& transfer);

    /// PQ of the luminance that a display shows for a linear signal: encode(transfer, pq_linear(light, x)). Within
    /// 6.4e-8 of that; 1 goes to the code of the peak.
    TransferEncoder(const PqTransfer& transfer, const DisplayLight& light);

    /// BT.1886 of the same: encode(transfer, shown_share(light, x)), since its codes stand for all light that the
    /// display gives, its black with it. Codes below 0 are 0.
    TransferEncoder(const Bt1886Transfer& transfer, const DisplayLight& light);

    /// In place. Components in [0, 1].
    void operator()(std::span<RGB> linear) const noexcept;

  private:
    std::variant<IdentityEncoder, StraightToeCurve, SquareRootToeCurve, ExactEncoder<GammaTransfer>,
                 ExactEncoder<TableTransfer>>
        encoder_;
};

}  // namespace emulsion
