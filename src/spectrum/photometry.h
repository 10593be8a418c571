#pragma once
// Radiometry to photometry: every radiometric quantity, per nm, has a photometric one, which is its integral with the
// luminous efficiency of an eye, times that eye's largest efficacy in lm/W:
//
//   luminous = K integral radiant(lambda) V(lambda) dlambda
//
// The factor K and the function are the same for all five pairs, so that the geometry (per area, per solid angle) goes
// from W to lm unchanged. What turns one quantity into another, such as the 4 pi sr between an isotropic source's
// intensity and its flux, is geometry, and none of this file.

#include <array>
#include <string_view>

#include "spectrum/observer.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// A pair of quantities.
struct PhotometricQuantity {
    std::string_view radiometric, radiometric_unit;  ///< the unit of its spectrum has a further nm^-1
    std::string_view photometric, photometric_unit;
    std::string_view unit_name;  ///< of the photometric unit
    bool operator==(const PhotometricQuantity&) const = default;
};

/// All pairs. Source: SI brochure, 9th ed., table 4; CIE S 017 (International Lighting Vocabulary).
inline constexpr std::array<PhotometricQuantity, 5> kPhotometricQuantities = {{
    {"radiant flux", "W", "luminous flux", "lm", "lumen"},
    {"radiant intensity", "W sr^-1", "luminous intensity", "lm sr^-1", "candela"},
    {"irradiance", "W m^-2", "illuminance", "lm m^-2", "lux"},
    {"radiosity", "W m^-2", "luminous exitance", "lm m^-2", "lux"},
    {"radiance", "W m^-2 sr^-1", "luminance", "lm m^-2 sr^-1", "nit"},
}};

/// How well an eye sees each wavelength: K V(lambda).
struct LuminousEfficiency {
    PiecewiseLinearSpectrum relative;  ///< V, dimensionless, 1 at its peak; nothing counts outside its wavelengths
    double max_lm_per_W = 683.0;       ///< K; finite, > 0
};

/// By day: V(lambda) of photopic_efficiency(), which is ybar of the CIE 1931 observer to 1e-12; 683 lm/W.
[[nodiscard]] const LuminousEfficiency& photopic();

/// By day, for another observer: its ybar, and 683 lm/W.
[[nodiscard]] LuminousEfficiency photopic(const Observer& observer);

/// By night: V'(lambda) of scotopic_efficiency(), and 1700 lm/W (kScotopicLuminousEfficacy).
[[nodiscard]] const LuminousEfficiency& scotopic();

/// K integral spectrum V: the photometric value of any of the pairs; lines without width count.
/// \throws std::invalid_argument as validate(Spectrum) does for either spectrum, and for a max_lm_per_W out of range.
[[nodiscard]] double photometric_value(const Spectrum& spectrum, const LuminousEfficiency& eye = photopic());

/// The same by the names of what goes in and what comes out.
[[nodiscard]] double luminous_flux_lm(const Spectrum& radiant_flux, const LuminousEfficiency& eye = photopic());
[[nodiscard]] double luminous_intensity_cd(const Spectrum& radiant_intensity,
                                           const LuminousEfficiency& eye = photopic());
[[nodiscard]] double illuminance_lux(const Spectrum& irradiance, const LuminousEfficiency& eye = photopic());
[[nodiscard]] double luminous_exitance_lm_m2(const Spectrum& radiosity, const LuminousEfficiency& eye = photopic());
[[nodiscard]] double luminance_nit(const Spectrum& radiance, const LuminousEfficiency& eye = photopic());

}  // namespace emulsion
