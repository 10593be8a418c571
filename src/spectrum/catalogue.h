#pragma once
// Every spectrum that the library has by name, with what is known of it: all columns of the tables of data/.
//
// Names are what users type: case makes no difference, nor do '-', '_', '.' and the space for one another.
//
//   A, C, D50, D55, D65, D75, E            illuminants; A and the D's to 300-830 nm, the others to 380-780 nm
//   FL1-FL12, FL3_1-FL3_15                 fluorescent lamps; FL11 is also F11
//   HP1-HP5, LED_B1, ...                   high-pressure discharge lamps, LEDs
//   colorchecker-dark-skin, ...            the 24 patches by their customary names, colorchecker-white to -black
//   VS1-VS15, TCS01-TCS14                  Munsell papers of colour quality, samples of colour rendering
//   ampas-patch1, ...                      camera training samples; patch125 is above 1 in places, as published
//   cornell-white, -green, -red, -light    the Cornell box
//   metal-Ag-eta, metal-Ag-k, ...          Ag, Al, Au, Cu by Palik, and CuZn (brass); n + i k, with n called eta
//   johnson-christy-Ag-eta, ...            Ag, Au, Cu by Johnson and Christy, 187.9-1937 nm
//   glass-N_BK7, ...                       at whole nm of 360-830, by the formula of spectrum/sellmeier.h
//   V, V_prime                             luminous efficiencies, by day and by night
//   cie_1931_2deg-xbar, ...                the functions of observers
//   S0, S1, S2                             components of daylight
//
// Names of scenes (spectrum/named_spectra.h) that begin with stdillum-, metal- and glass- mean the same here. So
// glass-F5 is what it is in pbrt-v4, the glass SF5; the catalogue's F5 is glass-schott-F5.
//
// Between its knots a spectrum is a straight line, outside of them 0. With that, the index of a glass is off its
// formula by less than 3e-6 between whole nm.

#include <string>
#include <string_view>
#include <vector>

#include "spectrum/spectrum.h"

namespace emulsion {

/// One named spectrum, and where it comes from.
struct NamedSpectrumInfo {
    std::string name;                  ///< "colorchecker-dark-skin"
    std::vector<std::string> aliases;  ///< other names of the same spectrum
    std::string_view group;            ///< one of spectrum_groups()
    std::string_view unit;             ///< "1" for dimensionless, "relative power"
    double first_nm = 0.0;
    double last_nm = 0.0;
    double step_nm = 0.0;     ///< 0 for irregular steps
    std::string_view table;   ///< the table it is found in, "colorchecker_reflectance"
    std::string column;       ///< its column there, or the row of a glass
    std::string_view source;  ///< what the first line of the table says of quantity, unit, range and source
};

/// "illuminant", "emission", "reflectance", "index of refraction", "extinction coefficient", "luminous efficiency",
/// "colour-matching function", "component of daylight".
[[nodiscard]] std::vector<std::string_view> spectrum_groups();

/// All spectra, group by group.
[[nodiscard]] const std::vector<NamedSpectrumInfo>& spectrum_catalogue();

/// The entry of this name or alias; nullptr if there is none.
[[nodiscard]] const NamedSpectrumInfo* find_in_catalogue(std::string_view name);

/// The values of an entry of the catalogue.
[[nodiscard]] PiecewiseLinearSpectrum spectrum_of(const NamedSpectrumInfo& entry);

/// The spectrum of this name or alias.
/// \throws std::invalid_argument for an unknown name, with the five known ones that are most like it, nearest first.
[[nodiscard]] PiecewiseLinearSpectrum catalogue_spectrum(std::string_view name);

}  // namespace emulsion
