#pragma once
// Spectra that scenes name in place of writing them out. The names are pbrt-v4's, letter by letter; the values are
// those of data/. Every spectrum that we have, by names in which case makes no difference: spectrum/catalogue.h.
//
// "stdillum-X": relative power of an illuminant. A, D50, D55, D65, D75 (300-830 nm), F1 to F12 (which the CIE calls FL1
// to FL12), and every other column of data/illuminants_5nm.csv (380-780 nm).
//
// "illum-acesD60": daylight of 6000 K, whose chromaticity is the white of ACES. Source: AMPAS TB-2018-001, appendix C.
//
// "metal-M-eta", "metal-M-k": complex index of refraction eta + i k of M = Ag, Al, Au, Cu, CuZn.
//
// "glass-X": index of refraction by Sellmeier's formula, at every nm of 360-830. BK7, BAF10, FK51A, LASF9; F5, F10,
// F11, which in pbrt-v4 are the glasses SF5, SF10, SF11; every glass of data/glasses.csv by its catalogue name (but the
// catalogue's F5, whose name is taken: "glass-schott-F5"). Below the catalogue's range (up to 30 nm, SF11) the formula
// is extrapolated.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spectrum/spectrum.h"

namespace emulsion {

/// Unset for a name that we don't have.
[[nodiscard]] std::optional<Spectrum> named_spectrum(std::string_view name);

/// Every name that named_spectrum knows, sorted.
[[nodiscard]] std::vector<std::string> named_spectrum_names();

/// Whether pbrt-v4 has a spectrum of this name, be it among ours or not: an error can then tell "not supported" from
/// "no such spectrum".
[[nodiscard]] bool is_known_to_pbrt(std::string_view name) noexcept;

}  // namespace emulsion
