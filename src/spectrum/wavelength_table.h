#pragma once
// The density tabulated from what the eye sees of the scene's light.

#include "spectrum/wavelength_cells.h"
#include "spectrum/wavelength_pdf.h"

namespace emulsion {

/// Density proportional to the importance of each nanometre (power of the light times xbar + ybar + zbar), mixed with a
/// uniform share. It is constant on each nanometre: straight lines in between gain nothing (FL11, N = 4: relative RMS
/// error of Y 0.114 beside 0.113), and need a square root.
///
/// The uniform share keeps the density of every wavelength above uniform_share / 470 nm, for what the light that the
/// table was made from doesn't hold: another light, or one that the table's maker didn't know of. Nothing can then be
/// missed, and no sample weighs more than 1 / uniform_share times what it does under the uniform density.
///
/// xbar + ybar + zbar, and not ybar: that would make the error of Y all but vanish, at 3 to 4 times (HP1: 5 times) that
/// of Z and X. The price is for lights that have little blue: HP1's Z (N = 4: 1.5) is no better than by uniform
/// sampling, as its Z is 5% of the whole.
class TabulatedWavelengthPdf {
  public:
    /// Lines are left out: a density can't draw them (LineWavelengthPdf does).
    /// \throws std::invalid_argument as WavelengthCells does; also if everything there is to see is in lines.
    explicit TabulatedWavelengthPdf(const WavelengthImportance& importance, float uniform_share = kDefaultUniformShare)
        : cells_(WavelengthImportance{importance.per_nm, {}}, uniform_share) {}

    [[nodiscard]] ExactWavelengthSample exact(double u) const noexcept {
        const WavelengthCells::ExactSample sample = cells_.exact(u);
        return {sample.lambda_nm, sample.pdf};
    }
    [[nodiscard]] WavelengthSample sample(double u) const noexcept {
        const WavelengthCells::Sample sample = cells_.sample(u);
        return {sample.lambda_nm, sample.pdf};
    }
    /// At a whole nanometre, the density above it (at the last, below).
    [[nodiscard]] double pdf(double lambda_nm) const noexcept { return cells_.pdf(lambda_nm); }

  private:
    WavelengthCells cells_;
};

}  // namespace emulsion
