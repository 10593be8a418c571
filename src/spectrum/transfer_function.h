#pragma once
// Transfer functions: between linear values, proportional to light, and encoded ones, even steps of which look about
// even. These are the exact definitions; src/display has fast ones in single precision, for pictures.
//
// Linear 1 is the display's white or the brightest light of the camera (for PQ 10000 cd/m^2), encoded 1 the largest
// nominal code. encode: linear to encoded; decode: back. 0 and 1 go exactly to themselves but where a function's
// header says otherwise (PQ at 0, HLG at 1, BT.1886 at a black above 0).
//
// Values outside [0, 1] are taken, too: above 1 the formula goes on, below 0 it is f(-x) = -f(x), as in scRGB (IEC
// 61966-2-2) and extended sYCC; only BT.1886 is odd about another point. NaN stays NaN, infinities go to infinity or
// to the function's limit. decode undoes encode but for what a header says about its knee.

#include <variant>

#include "core/named_value.h"
#include "spectrum/adobe_rgb_transfer.h"
#include "spectrum/bt1886_transfer.h"
#include "spectrum/bt2020_transfer.h"
#include "spectrum/bt709_transfer.h"
#include "spectrum/gamma_transfer.h"
#include "spectrum/hlg.h"
#include "spectrum/linear_transfer.h"
#include "spectrum/pq.h"
#include "spectrum/prophoto_transfer.h"
#include "spectrum/srgb_transfer.h"
#include "spectrum/table_transfer.h"

namespace emulsion {

/// All transfer functions; the first is the default.
using TransferFunction =
    std::variant<SrgbTransfer, LinearTransfer, GammaTransfer, Bt709Transfer, Bt2020Transfer, Bt1886Transfer, PqTransfer,
                 HlgTransfer, ProPhotoTransfer, AdobeRgbTransfer, TableTransfer>;

/// \param transfer with parameters in their ranges, as parse_named gives and validate_named checks
[[nodiscard]] inline double encode(const TransferFunction& transfer, double linear) noexcept {
    return visit_noexcept([&](const auto& chosen) { return encode(chosen, linear); }, transfer);
}
[[nodiscard]] inline double decode(const TransferFunction& transfer, double encoded) noexcept {
    return visit_noexcept([&](const auto& chosen) { return decode(chosen, encoded); }, transfer);
}

}  // namespace emulsion
