#include "spectrum/spectrum_daylight.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "spectrum/data_table.h"
#include "spectrum/spectrum_checks.h"
#include "spectrum/spectrum_linear.h"

namespace emulsion {

namespace {

/// S0, S1 and S2.
const std::array<DenseSpectrum, 3>& components() {
    static const std::array<DenseSpectrum, 3> made = [] {
        const DataTable& table = data_table("cie_daylight_basis_5nm");
        const std::vector<double>& lambda_nm = table.column("wavelength");
        const auto component = [&](const char* name) {
            return DenseSpectrum{lambda_nm[0], lambda_nm[1] - lambda_nm[0], table.column(name), Extrapolation::zero};
        };
        return std::array{component("S0"), component("S1"), component("S2")};
    }();
    return made;
}

void require_daylight(double temperature_K) {
    if (!(temperature_K >= kMinDaylight_K && temperature_K <= kMaxDaylight_K)) {
        throw_bad_spectrum("daylight: temperature_K", temperature_K, "a number in [4000, 25000]");
    }
}

Chromaticity on_locus(double temperature_K) noexcept {
    const double r = 1.0 / temperature_K;
    const double x = temperature_K <= 7000.0 ? ((-4.6070e9 * r + 2.9678e6) * r + 0.09911e3) * r + 0.244063
                                             : ((-2.0064e9 * r + 1.9018e6) * r + 0.24748e3) * r + 0.237040;
    return {x, (-3.000 * x + 2.870) * x - 0.275};
}

}  // namespace

Chromaticity daylight_chromaticity(double temperature_K) {
    require_daylight(temperature_K);
    return on_locus(temperature_K);
}

std::array<double, 2> daylight_weights(const Chromaticity& chromaticity) noexcept {
    const auto [x, y] = chromaticity;
    const double denominator = 0.0241 + 0.2562 * x - 0.7341 * y;
    return {(-1.3515 - 1.7703 * x + 5.9114 * y) / denominator, (0.0300 - 31.4424 * x + 30.0717 * y) / denominator};
}

void eval(const DaylightSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    auto [m1, m2] = daylight_weights(on_locus(spectrum.temperature_K));
    if (spectrum.weights == DaylightWeights::three_decimals) {
        m1 = std::round(1000.0 * m1) / 1000.0;
        m2 = std::round(1000.0 * m2) / 1000.0;
    }
    const std::array weights = {1.0, m1, m2};
    for_each_block(at, values,
                   [&weights](const OffsetWavelengths& block, std::span<double> sum, std::span<double> part) {
                       std::fill(sum.begin(), sum.end(), 0.0);
                       for (std::size_t j = 0; j < weights.size(); ++j) {
                           eval(components()[j], block, part);
                           for (std::size_t i = 0; i < block.size(); ++i) sum[i] += weights[j] * part[i];
                       }
                   });
}

double limit(const DaylightSpectrum& spectrum, double lambda_nm, Side side) noexcept {
    const DenseSpectrum& s0 = components()[0];
    if (lambda_nm == (side == Side::below ? s0.first_nm : s0.last_nm())) return 0.0;
    double value = 0.0;
    eval(spectrum, {lambda_nm, std::array{0.0}}, {&value, 1});
    return value;
}

std::vector<double> knots_nm(const DaylightSpectrum&) { return knots_nm(components()[0]); }

void validate(const DaylightSpectrum& spectrum) { require_daylight(spectrum.temperature_K); }

}  // namespace emulsion
