#include "spectrum/spectrum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "core/visit.h"
#include "spectrum/blackbody.h"
#include "spectrum/sigmoid.h"

namespace emulsion {

namespace {

double value_of(const ConstantSpectrum& spectrum, double) noexcept { return spectrum.value; }

double value_of(const PiecewiseLinearSpectrum& spectrum, double lambda_nm) noexcept {
    const auto& x = spectrum.lambda_nm;
    if (x.empty() || !(lambda_nm >= x.front() && lambda_nm <= x.back())) return 0.0;
    const auto upper = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), lambda_nm) - x.begin());
    if (upper == x.size()) return spectrum.value.back();
    const double t = (lambda_nm - x[upper - 1]) / (x[upper] - x[upper - 1]);
    return (1.0 - t) * spectrum.value[upper - 1] + t * spectrum.value[upper];
}

double value_of(const BlackbodySpectrum& spectrum, double lambda_nm) noexcept {
    return relative_planck_radiance(spectrum.temperature_K, lambda_nm);
}

double value_of(const SigmoidSpectrum& spectrum, double lambda_nm) noexcept {
    const double t = (lambda_nm - 360.0) / 470.0;
    return sigmoid((spectrum.c[0] * t + spectrum.c[1]) * t + spectrum.c[2]);
}

double value_of(const RgbIlluminantSpectrum& spectrum, double lambda_nm) noexcept {
    return spectrum.scale * value_of(spectrum.sigmoid, lambda_nm) * value_of(spectrum.illuminant, lambda_nm);
}

// The part of a spectrum that has knots, if any.
const PiecewiseLinearSpectrum* piecewise_part(const Spectrum& spectrum) noexcept {
    if (const auto* light = std::get_if<RgbIlluminantSpectrum>(&spectrum)) return &light->illuminant;
    return std::get_if<PiecewiseLinearSpectrum>(&spectrum);
}

[[noreturn]] void fail(std::string_view field, double value, std::string_view expected) {
    throw std::invalid_argument(fmt::format("{} = {}: expected {}", field, value, expected));
}

void require_finite(std::string_view field, double value) {
    if (!std::isfinite(value)) fail(field, value, "a finite number");
}

void check(const ConstantSpectrum& spectrum) { require_finite("constant spectrum: value", spectrum.value); }

void check(const PiecewiseLinearSpectrum& spectrum) {
    const std::vector<double>& x = spectrum.lambda_nm;
    if (x.empty() || x.size() != spectrum.value.size()) {
        throw std::invalid_argument(
            fmt::format("piecewise linear spectrum: {} wavelengths and {} values: expected as many, and at least one",
                        x.size(), spectrum.value.size()));
    }
    const auto field = [](std::string_view name, std::size_t i) {
        return fmt::format("piecewise linear spectrum: {}[{}]", name, i);
    };
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!std::isfinite(x[i])) fail(field("lambda_nm", i), x[i], "a finite number");
        if (!std::isfinite(spectrum.value[i])) fail(field("value", i), spectrum.value[i], "a finite number");
        if (i > 0 && x[i] <= x[i - 1]) {
            fail(field("lambda_nm", i), x[i], fmt::format("more than the one before, {}", x[i - 1]));
        }
    }
}

void check(const BlackbodySpectrum& spectrum) {
    const double temperature_K = spectrum.temperature_K;
    if (!std::isfinite(temperature_K) || temperature_K <= 0.0) {
        fail("blackbody: temperature_K", temperature_K, "a finite number > 0");
    }
}

void check(const SigmoidSpectrum& spectrum) {
    require_finite("sigmoid spectrum: c[0]", spectrum.c[0]);
    require_finite("sigmoid spectrum: c[1]", spectrum.c[1]);
    if (std::isnan(spectrum.c[2])) fail("sigmoid spectrum: c[2]", spectrum.c[2], "a number");
}

void check(const RgbIlluminantSpectrum& spectrum) {
    check(spectrum.sigmoid);
    check(spectrum.illuminant);
    require_finite("RGB illuminant: scale", spectrum.scale);
}

}  // namespace

double eval(const Spectrum& spectrum, double lambda_nm) noexcept {
    // An assignment that ran out of memory leaves a spectrum without a value.
    if (spectrum.valueless_by_exception()) return std::numeric_limits<double>::quiet_NaN();
    return visit_noexcept([lambda_nm](const auto& alternative) { return value_of(alternative, lambda_nm); }, spectrum);
}

double limit(const Spectrum& spectrum, double lambda_nm, Side side) noexcept {
    const PiecewiseLinearSpectrum* piecewise = piecewise_part(spectrum);
    if (piecewise != nullptr && !piecewise->lambda_nm.empty()) {
        const double outer_end_nm = side == Side::below ? piecewise->lambda_nm.front() : piecewise->lambda_nm.back();
        if (lambda_nm == outer_end_nm) return 0.0;
    }
    return eval(spectrum, lambda_nm);
}

std::vector<double> knots_nm(const Spectrum& spectrum) {
    const PiecewiseLinearSpectrum* piecewise = piecewise_part(spectrum);
    return piecewise == nullptr ? std::vector<double>{} : piecewise->lambda_nm;
}

void validate(const Spectrum& spectrum) {
    std::visit([](const auto& alternative) { check(alternative); }, spectrum);
}

}  // namespace emulsion
