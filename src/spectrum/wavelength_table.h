#pragma once
// The density tabulated from what the eye sees of the scene's light.

#include "spectrum/wavelength_cells.h"
#include "spectrum/wavelength_pdf.h"

namespace emulsion {

/// Density proportional to the importance of each nanometre (power of the light times xbar + ybar + zbar), mixed with a
/// uniform share. It is constant on each nanometre: straight lines between whole nanometres gain little (FL11, N = 4:
/// relative RMS error of Y 0.109 for 0.114), and need a square root.
///
/// The uniform share keeps the density of every wavelength above uniform_share / 470 nm, for what the light that the
/// table was made from doesn't hold: another light, or one that the table's maker didn't know of. Nothing can then be
/// missed, and no sample weighs more than 1 / uniform_share times what it does under the uniform density.
///
/// xbar + ybar + zbar, and not ybar: the error of Y would become smaller yet (FL11, N = 4: 0.085), but that of X 0.44
/// in place of 0.16, and of Z 3.6 in place of 0.23. The price is paid by lights with little blue: HP1's Z, 5% of its X
/// + Y
/// + Z, has an error of 1.52, and 0.92 by uniform sampling.
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
