#pragma once
// How the columns of the tables are called in the catalogue. For catalogue.cpp alone.

#include <cstddef>
#include <string_view>
#include <vector>

#include "spectrum/catalogue.h"

namespace emulsion {

inline constexpr std::string_view kIlluminantGroup = "illuminant";
inline constexpr std::string_view kEmissionGroup = "emission";
inline constexpr std::string_view kReflectanceGroup = "reflectance";
inline constexpr std::string_view kIndexGroup = "index of refraction";
inline constexpr std::string_view kExtinctionGroup = "extinction coefficient";
inline constexpr std::string_view kEfficiencyGroup = "luminous efficiency";
inline constexpr std::string_view kMatchingGroup = "colour-matching function";
inline constexpr std::string_view kDaylightGroup = "component of daylight";

inline constexpr std::string_view kGlassTable = "glasses";

/// Every column of every table that holds spectra, and every glass: name, aliases, group, unit, table and column are
/// set, the rest is not. Where two tables have a name, both entries are here, the preferred one first.
[[nodiscard]] std::vector<NamedSpectrumInfo> named_columns();

}  // namespace emulsion
