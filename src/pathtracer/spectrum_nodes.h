#pragma once
// A spectrum by integrals around whole nanometres, for sums over many products of spectra.

#include <vector>

#include "spectrum/spectrum.h"

namespace emulsion {

/// Integrals with the triangles that rise from 0 at the nanometre before to 1 and fall to 0 at the one after, for each
/// whole nanometre of the visible; nm times the unit of the spectrum. Their sum is the integral over the visible, lines
/// of any width included, to single precision.
/// \throws std::invalid_argument as SpectrumTable does.
[[nodiscard]] std::vector<double> node_integrals(const Spectrum& spectrum);

}  // namespace emulsion
