#include "spectrum/spectrum_smooth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "spectrum/sigmoid.h"
#include "spectrum/spectrum_checks.h"

namespace emulsion {

namespace {

constexpr double kSigmoidStart_nm = 360.0, kSigmoidRange_nm = 470.0;

}  // namespace

void eval(const ConstantSpectrum& spectrum, const OffsetWavelengths&, std::span<double> values) noexcept {
    std::fill(values.begin(), values.end(), spectrum.value);
}

void eval(const SigmoidSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double t = ((at.base_nm - kSigmoidStart_nm) + at.offset_nm[i]) / kSigmoidRange_nm;
        values[i] = sigmoid((spectrum.c[0] * t + spectrum.c[1]) * t + spectrum.c[2]);
    }
}

void eval(const RgbIlluminantSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    for_each_block(at, values, [&](const OffsetWavelengths& block, std::span<double> product, std::span<double> light) {
        eval(spectrum.sigmoid, block, product);
        eval(spectrum.illuminant, block, light);
        for (std::size_t i = 0; i < block.size(); ++i) product[i] = spectrum.scale * product[i] * light[i];
    });
}

std::vector<double> steep_places_nm(const SigmoidSpectrum& spectrum, double from_nm, double to_nm) {
    const auto [a, b, c] = spectrum.c;
    std::vector<double> places;
    const auto add = [&](double t) {
        const double lambda_nm = kSigmoidStart_nm + kSigmoidRange_nm * t;
        if (lambda_nm > from_nm && lambda_nm < to_nm) places.push_back(lambda_nm);
    };
    // Around t, where the argument grows by 1 over `width`: the tails fall with its square, so ever wider steps do.
    const auto add_around = [&](double t, double width) {
        add(t);
        double distance = width;
        while (distance < 1.0) {
            if (t + distance != t) {
                add(t - distance);
                add(t + distance);
            }
            distance *= 6.0;
        }
    };
    if (!std::isfinite(c)) return places;
    if (a == 0.0) {
        if (b != 0.0) add_around(-c / b, 1.0 / std::abs(b));
        return places;
    }
    add_around(-0.5 * b / a, 1.0 / std::sqrt(std::abs(a)));
    const double discriminant = b * b - 4.0 * a * c;
    if (!(discriminant > 0.0)) return places;
    // The root that has no cancellation first, and the other from their product.
    const double root = std::sqrt(discriminant);
    const double q = -0.5 * (b + std::copysign(root, b));
    add_around(q / a, 1.0 / root);
    add_around(c / q, 1.0 / root);
    return places;
}

void validate(const ConstantSpectrum& spectrum) { require_finite("constant spectrum: value", spectrum.value); }

void validate(const SigmoidSpectrum& spectrum) {
    require_finite("sigmoid spectrum: c[0]", spectrum.c[0]);
    require_finite("sigmoid spectrum: c[1]", spectrum.c[1]);
    if (std::isnan(spectrum.c[2])) throw_bad_spectrum("sigmoid spectrum: c[2]", spectrum.c[2], "a number");
}

void validate(const RgbIlluminantSpectrum& spectrum) {
    validate(spectrum.sigmoid);
    validate(spectrum.illuminant);
    require_finite("RGB illuminant: scale", spectrum.scale);
}

}  // namespace emulsion
