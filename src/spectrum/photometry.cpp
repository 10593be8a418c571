#include "spectrum/photometry.h"

#include <utility>
#include <vector>

#include "core/units.h"
#include "spectrum/integral.h"
#include "spectrum/luminous_efficiency.h"
#include "spectrum/spectrum_checks.h"

namespace emulsion {

const LuminousEfficiency& photopic() {
    static const LuminousEfficiency eye = {photopic_efficiency(), kLuminousEfficacy};
    return eye;
}

LuminousEfficiency photopic(const Observer& observer) {
    PiecewiseLinearSpectrum ybar;
    for (const XYZd& value : observer.value) {
        ybar.lambda_nm.push_back(observer.first_nm + static_cast<double>(ybar.value.size()));
        ybar.value.push_back(value.y);
    }
    return {std::move(ybar), kLuminousEfficacy};
}

const LuminousEfficiency& scotopic() {
    static const LuminousEfficiency eye = {scotopic_efficiency(), kScotopicLuminousEfficacy};
    return eye;
}

double photometric_value(const Spectrum& spectrum, const LuminousEfficiency& eye) {
    require_positive("luminous efficiency: max_lm_per_W", eye.max_lm_per_W);
    validate(eye.relative);
    const std::vector<double>& knots = eye.relative.lambda_nm;
    const Spectrum v = eye.relative;
    return eye.max_lm_per_W * integral_of_product({spectrum, v}, knots.front(), knots.back());
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
