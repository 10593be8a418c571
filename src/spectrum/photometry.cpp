#include "spectrum/photometry.h"

#include <utility>

#include "core/units.h"
#include "spectrum/data_table.h"
#include "spectrum/integral.h"
#include "spectrum/spectrum_checks.h"

namespace emulsion {

const LuminousEfficiency& photopic() {
    static const LuminousEfficiency eye = photopic(cie_1931_2deg());
    return eye;
}

LuminousEfficiency photopic(const Observer& observer) {
    DenseSpectrum ybar{static_cast<double>(observer.first_nm), 1.0, {}, Extrapolation::zero};
    for (const XYZd& value : observer.value) ybar.value.push_back(value.y);
    return {std::move(ybar), kLuminousEfficacy};
}

const LuminousEfficiency& scotopic() {
    static const LuminousEfficiency eye = [] {
        const DataTable& table = data_table("cie_1951_scotopic_1nm");
        return LuminousEfficiency{{table.column("wavelength").front(), 1.0, table.column("V_prime")},
                                  kScotopicLuminousEfficacy};
    }();
    return eye;
}

double photometric_value(const Spectrum& spectrum, const LuminousEfficiency& eye) {
    require_positive("luminous efficiency: max_lm_per_W", eye.max_lm_per_W);
    const Spectrum v = eye.relative;
    return eye.max_lm_per_W * integral_of_product({spectrum, v}, eye.relative.first_nm, eye.relative.last_nm());
}

double luminous_flux_lm(const Spectrum& radiant_flux, const LuminousEfficiency& eye) {
    return photometric_value(radiant_flux, eye);
}

double luminous_intensity_cd(const Spectrum& radiant_intensity, const LuminousEfficiency& eye) {
    return photometric_value(radiant_intensity, eye);
}

double illuminance_lux(const Spectrum& irradiance, const LuminousEfficiency& eye) {
    return photometric_value(irradiance, eye);
}

double luminous_exitance_lm_m2(const Spectrum& radiosity, const LuminousEfficiency& eye) {
    return photometric_value(radiosity, eye);
}

double luminance_nit(const Spectrum& radiance, const LuminousEfficiency& eye) {
    return photometric_value(radiance, eye);
}

}  // namespace emulsion
