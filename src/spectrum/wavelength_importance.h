#pragma once
// How much each wavelength of a light matters to the eye: the power of the light times xbar + ybar + zbar. Relative:
// only ratios count. A light may have lines without width beside its continuum; they are counted in the same measure,
// so that "the lines are 30% of it" has a meaning.

#include <array>
#include <cstddef>
#include <vector>

#include "core/units.h"
#include "spectrum/observer.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// The number of whole nanometres of the range that rendering covers.
inline constexpr std::size_t kWavelengthCells = kMaxWavelength_nm - kMinWavelength_nm;

/// The most lines that are drawn from: 4096 with the nanometres.
inline constexpr std::size_t kMaxWavelengthLines = 4096 - kWavelengthCells;

/// What the eye makes of a line without width.
struct LineImportance {
    double lambda_nm = 0.0;   ///< in [kMinWavelength_nm, kMaxWavelength_nm]
    double importance = 0.0;  ///< finite, >= 0
    bool operator==(const LineImportance&) const = default;
};

/// Importance by nanometre, and of each line.
struct WavelengthImportance {
    std::array<double, kWavelengthCells> per_nm{};  ///< of [360 + i, 361 + i] nm; finite, >= 0
    std::vector<LineImportance> lines;              ///< at most kMaxWavelengthLines
    bool operator==(const WavelengthImportance&) const = default;
};

/// Of a light, continuum and lines, for one observer; for a scene with several lights, of their sum (sum_of).
/// Integrated between the knots of the continuum, so that a band narrower than a nanometre isn't overlooked. The
/// absolute value is taken of what is negative: a density can't be, and light that is taken away must be sampled too.
/// The lines are those of delta_lines(light), in that order, but for those outside the range, which can't be seen.
/// \throws std::invalid_argument as validate(Spectrum) does.
[[nodiscard]] WavelengthImportance wavelength_importance(const Spectrum& light,
                                                         const Observer& observer = cie_1931_2deg());

/// The powers that one light of the scene has on the lines of `importance`, by their index; 0 on those of others. What
/// a renderer keeps beside the light's continuum (wavelength_lines.h).
/// \throws std::invalid_argument as validate(Spectrum) does, and for a line within the range that is not among those of
/// `importance`: it would be missed.
[[nodiscard]] std::vector<double> line_powers(const Spectrum& light, const WavelengthImportance& importance);

/// \throws std::invalid_argument for a number out of its range, if all are 0, and if there are more than
/// kMaxWavelengthLines lines.
void validate(const WavelengthImportance& importance);

}  // namespace emulsion
