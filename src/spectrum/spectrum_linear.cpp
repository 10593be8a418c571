#include "spectrum/spectrum_linear.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "spectrum/spectrum_checks.h"

namespace emulsion {

namespace {

/// A wavelength in two parts, as in OffsetWavelengths.
struct Wavelength {
    double base_nm, offset_nm;
    [[nodiscard]] double nm() const noexcept { return base_nm + offset_nm; }
    [[nodiscard]] double above(double lambda_nm) const noexcept { return (base_nm - lambda_nm) + offset_nm; }
};

double on_line(double t, double start, double end) noexcept { return (1.0 - t) * start + t * end; }

/// Knots and values in the order in which they are read, whatever holds them.
template <class Table>
double outside(const Table& table, std::size_t count, Wavelength at, bool is_below) noexcept {
    const std::size_t end = is_below ? 0 : count - 1;
    if (table.extrapolation == Extrapolation::zero) return 0.0;
    if (table.extrapolation == Extrapolation::hold || count < 2) return table.value[end];
    const std::size_t inner = is_below ? 1 : count - 2;
    const auto knot_nm = [&](std::size_t i) {
        if constexpr (requires { table.step_nm; }) {
            return table.lambda_nm(i);
        } else {
            return table.lambda_nm[i];
        }
    };
    const double slope = (table.value[inner] - table.value[end]) / (knot_nm(inner) - knot_nm(end));
    return table.value[end] + slope * at.above(knot_nm(end));
}

/// The index of the first knot above lambda_nm, which lies between the first and the last. `guess` is that of another
/// wavelength: if this one is a few knots further, no search is needed.
std::size_t knot_above(const std::vector<double>& x, double lambda_nm, std::size_t guess) noexcept {
    constexpr std::size_t kMaxSteps = 8;
    const bool is_ahead = guess > 0 && x[guess - 1] <= lambda_nm;
    if (is_ahead) {
        for (std::size_t step = 0; step < kMaxSteps; ++step, ++guess) {
            if (guess == x.size() || x[guess] > lambda_nm) return guess;
        }
    }
    const auto from = is_ahead ? x.begin() + static_cast<std::ptrdiff_t>(guess) : x.begin();
    return static_cast<std::size_t>(std::upper_bound(from, x.end(), lambda_nm) - x.begin());
}

void require_samples(std::string_view type, const std::vector<double>& value, Extrapolation extrapolation) {
    for (std::size_t i = 0; i < value.size(); ++i) require_finite(fmt::format("{}: value[{}]", type, i), value[i]);
    if (extrapolation == Extrapolation::straight && value.size() < 2) {
        throw std::invalid_argument(fmt::format(
            "{}: {} samples: expected at least 2, to go on in a straight line outside them", type, value.size()));
    }
}

}  // namespace

void eval(const PiecewiseLinearSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    const std::vector<double>& x = spectrum.lambda_nm;
    std::size_t upper = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const Wavelength here = {at.base_nm, at.offset_nm[i]};
        const double lambda_nm = here.nm();
        if (x.empty() || std::isnan(lambda_nm)) {
            values[i] = 0.0;
        } else if (lambda_nm < x.front() || lambda_nm > x.back()) {
            values[i] = outside(spectrum, x.size(), here, lambda_nm < x.front());
        } else {
            upper = knot_above(x, lambda_nm, upper);
            if (upper == x.size()) {
                values[i] = spectrum.value.back();
                continue;
            }
            const double t = here.above(x[upper - 1]) / (x[upper] - x[upper - 1]);
            values[i] = on_line(t, spectrum.value[upper - 1], spectrum.value[upper]);
        }
    }
}

void eval(const DenseSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    const std::vector<double>& value = spectrum.value;
    const double last_nm = spectrum.last_nm();
    for (std::size_t i = 0; i < at.size(); ++i) {
        const Wavelength here = {at.base_nm, at.offset_nm[i]};
        const double lambda_nm = here.nm();
        if (value.empty() || std::isnan(lambda_nm)) {
            values[i] = 0.0;
        } else if (lambda_nm < spectrum.first_nm || lambda_nm > last_nm) {
            values[i] = outside(spectrum, value.size(), here, lambda_nm < spectrum.first_nm);
        } else if (value.size() == 1) {
            values[i] = value.front();
        } else {
            const double steps = here.above(spectrum.first_nm) / spectrum.step_nm;
            const auto cell = std::min(static_cast<std::size_t>(std::max(steps, 0.0)), value.size() - 2);
            // Rounding may have found the neighbouring cell, whose line meets this one's here.
            const double t = here.above(spectrum.lambda_nm(cell)) / spectrum.step_nm;
            values[i] = on_line(t, value[cell], value[cell + 1]);
        }
    }
}

double limit(const PiecewiseLinearSpectrum& spectrum, double lambda_nm, Side side) noexcept {
    if (!spectrum.lambda_nm.empty() && spectrum.extrapolation == Extrapolation::zero) {
        const double outer_end_nm = side == Side::below ? spectrum.lambda_nm.front() : spectrum.lambda_nm.back();
        if (lambda_nm == outer_end_nm) return 0.0;
    }
    double value = 0.0;
    eval(spectrum, {lambda_nm, std::array{0.0}}, {&value, 1});
    return value;
}

double limit(const DenseSpectrum& spectrum, double lambda_nm, Side side) noexcept {
    if (spectrum.extrapolation == Extrapolation::zero) {
        const double outer_end_nm = side == Side::below ? spectrum.first_nm : spectrum.last_nm();
        if (lambda_nm == outer_end_nm) return 0.0;
    }
    double value = 0.0;
    eval(spectrum, {lambda_nm, std::array{0.0}}, {&value, 1});
    return value;
}

std::vector<double> knots_nm(const PiecewiseLinearSpectrum& spectrum) { return spectrum.lambda_nm; }

std::vector<double> knots_nm(const DenseSpectrum& spectrum) {
    std::vector<double> knots(spectrum.value.size());
    for (std::size_t i = 0; i < knots.size(); ++i) knots[i] = spectrum.lambda_nm(i);
    return knots;
}

void validate(const PiecewiseLinearSpectrum& spectrum) {
    constexpr std::string_view kType = "piecewise linear spectrum";
    const std::vector<double>& x = spectrum.lambda_nm;
    if (x.empty() || x.size() != spectrum.value.size()) {
        throw std::invalid_argument(fmt::format("{}: {} wavelengths and {} values: expected as many, and at least one",
                                                kType, x.size(), spectrum.value.size()));
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::string field = fmt::format("{}: lambda_nm[{}]", kType, i);
        require_finite(field, x[i]);
        if (i > 0 && x[i] <= x[i - 1]) {
            throw_bad_spectrum(field, x[i], fmt::format("more than the one before, {}", x[i - 1]));
        }
    }
    require_samples(kType, spectrum.value, spectrum.extrapolation);
}

void validate(const DenseSpectrum& spectrum) {
    constexpr std::string_view kType = "dense spectrum";
    if (spectrum.value.empty()) {
        throw std::invalid_argument(fmt::format("{}: 0 values: expected at least one", kType));
    }
    require_finite("dense spectrum: first_nm", spectrum.first_nm);
    require_positive("dense spectrum: step_nm", spectrum.step_nm);
    const double last_nm = spectrum.last_nm();
    const double resolution_nm =
        std::numeric_limits<double>::epsilon() * std::max(std::abs(spectrum.first_nm), std::abs(last_nm));
    if (!std::isfinite(last_nm) || spectrum.step_nm <= resolution_nm) {
        throw_bad_spectrum("dense spectrum: step_nm", spectrum.step_nm,
                           fmt::format("more than {} and a finite last wavelength (it is {})", resolution_nm, last_nm));
    }
    require_samples(kType, spectrum.value, spectrum.extrapolation);
}

}  // namespace emulsion
