#pragma once
// The errors of a picture's rows, kept while they are rounded for the rows below: display/diffuse_rows.h.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "display/diffusion_kernel.h"
#include "display/wavefront.h"

namespace emulsion {

/// An error in units of display/code_units.h. A white part at the right border takes errors from its left that find no
/// code, row by row: fewer than 0.12 codes a row (tests/display/diffusion_kernel_test.cpp). So 7/16 of the error of
/// kMostErrorRows are within 32 bits.
using ErrorUnits = std::int32_t;
inline constexpr int kMostErrorRows = 1 << 15;

/// The errors of a row as the rows below want them; 0 beside it, and for pixels that hand theirs down themselves.
struct RowErrors {
    std::vector<ErrorUnits> parts;  ///< the error where shares are rounded each, else the divisor's part of it
    std::vector<ErrorUnits> rests;  ///< what goes below; empty where shares are rounded each

    template <const DiffusionKernel& Kernel>
    static RowErrors make(std::size_t size) {
        return {std::vector<ErrorUnits>(size),
                std::vector<ErrorUnits>(Kernel.rounding == ShareRounding::parts ? size : 0)};
    }
};

/// Which rows' errors are kept in the same memory, so that what is worked on stays in the processor's cache. Of a band
/// of a Wavefront, the last rows wait for the band below. The others take turns in three: tiles lean so far that a row
/// is read for the last time, by the two below it, before the third one below it is written there.
class ErrorRows {
  public:
    ErrorRows(const Wavefront& wavefront, int reach) noexcept
        : rows_(wavefront.rows_of_band()),
          reach_(reach),
          bands_(wavefront.bands_at_once() + 2),
          places_(rows_ == 1 ? 1 : kTurns + reach) {}

    [[nodiscard]] std::size_t count() const noexcept {
        return static_cast<std::size_t>(bands_) * static_cast<std::size_t>(places_);
    }
    [[nodiscard]] std::size_t place_of(int y) const noexcept {
        const int row = y % rows_, from_last = rows_ - 1 - row;
        const int place = rows_ > 1 && from_last < reach_ ? kTurns + from_last : row % kTurns;
        const int band = y / rows_ % bands_;
        return static_cast<std::size_t>(band) * static_cast<std::size_t>(places_) + static_cast<std::size_t>(place);
    }

  private:
    static constexpr int kTurns = 3;
    int rows_, reach_, bands_, places_;
};

}  // namespace emulsion
