#include "spectrum/colorimetry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <variant>
#include <vector>

#include "core/units.h"

namespace emulsion {

namespace {

// Adaptive Simpson's rule with Richardson's correction: exact for cubics (the product of up to three straight lines),
// halved where that isn't enough. fa, fm, fb: values at the ends and in the middle.
template <class Function>
double adaptive_simpson(const Function& f, double a, double b, double fa, double fm, double fb, int depth) {
    const double m = 0.5 * (a + b);
    const double f_left = f(0.5 * (a + m)), f_right = f(0.5 * (m + b));
    const double whole = (b - a) / 6.0 * (fa + 4.0 * fm + fb);
    const double halves = (b - a) / 12.0 * (fa + 4.0 * f_left + 2.0 * fm + 4.0 * f_right + fb);
    const double magnitude = (b - a) * (std::abs(fa) + std::abs(fm) + std::abs(fb));
    const double difference = halves - whole;
    if (depth == 0 || std::abs(difference) <= 1e-11 * magnitude) return halves + difference / 15.0;
    return adaptive_simpson(f, a, m, fa, f_left, fm, depth - 1) + adaptive_simpson(f, m, b, fm, f_right, fb, depth - 1);
}

// Where an integral over the observer's range has to be cut: every knot of observer and spectra.
std::vector<double> cuts_nm(const Observer& observer, std::initializer_list<const Spectrum*> spectra) {
    std::vector<double> cuts;
    for (int lambda_nm = observer.first_nm; lambda_nm <= observer.last_nm(); ++lambda_nm) cuts.push_back(lambda_nm);
    for (const Spectrum* spectrum : spectra) {
        for (const double lambda_nm : knots_nm(*spectrum)) {
            if (lambda_nm > observer.first_nm && lambda_nm < observer.last_nm()) cuts.push_back(lambda_nm);
        }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
}

// Integral over nm of the spectra's product times one of the observer's functions.
double integral(std::initializer_list<const Spectrum*> spectra, const Observer& observer, double XYZd::*function) {
    constexpr int kMaxDepth = 30;
    const auto at_end = [&](double lambda_nm, Side side) {
        double product = eval(observer, lambda_nm).*function;
        for (const Spectrum* spectrum : spectra) product *= limit(*spectrum, lambda_nm, side);
        return product;
    };
    const auto inside = [&](double lambda_nm) {
        double product = eval(observer, lambda_nm).*function;
        for (const Spectrum* spectrum : spectra) product *= eval(*spectrum, lambda_nm);
        return product;
    };
    const std::vector<double> cuts = cuts_nm(observer, spectra);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double a = cuts[i], b = cuts[i + 1];
        // The limits are those from inside the interval: spectra may jump at its ends.
        sum += adaptive_simpson(inside, a, b, at_end(a, Side::above), inside(0.5 * (a + b)), at_end(b, Side::below),
                                kMaxDepth);
    }
    return sum;
}

}  // namespace

double photometric_integral(const Spectrum& spectrum) {
    validate(spectrum);
    return integral({&spectrum}, cie_1931_2deg(), &XYZd::y);
}

double light_normalisation(const Spectrum& spectrum) {
    if (const auto* light = std::get_if<RgbIlluminantSpectrum>(&spectrum)) {
        validate(spectrum);
        return photometric_integral(light->illuminant);
    }
    return photometric_integral(spectrum);
}

XYZd xyz_of_radiance(const Spectrum& radiance, const Observer& observer) {
    validate(radiance);
    const auto component = [&](double XYZd::*function) { return integral({&radiance}, observer, function); };
    return kLuminousEfficacy * XYZd{component(&XYZd::x), component(&XYZd::y), component(&XYZd::z)};
}

XYZd xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& illuminant, const Observer& observer) {
    validate(reflectance);
    validate(illuminant);
    const double white = integral({&illuminant}, observer, &XYZd::y);
    if (!(std::abs(white) > 0.0)) {
        throw std::invalid_argument("illuminant: its luminance is 0, expected another value");
    }
    const auto component = [&](double XYZd::*function) {
        return integral({&reflectance, &illuminant}, observer, function) / white;
    };
    return {component(&XYZd::x), component(&XYZd::y), component(&XYZd::z)};
}

}  // namespace emulsion
