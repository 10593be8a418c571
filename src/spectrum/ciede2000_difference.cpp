#include "spectrum/ciede2000_difference.h"

#include <cmath>
#include <numbers>

namespace emulsion {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// sqrt(C^7 / (C^7 + 25^7)), put so that no power leaves the range of a double.
double seventh_power_share(double chroma) noexcept { return std::sqrt(1.0 / (1.0 + std::pow(25.0 / chroma, 7.0))); }

struct ChromaAndHue {
    double chroma, hue_degrees;  ///< hue in [0, 360); 0 for grey
};

ChromaAndHue chroma_and_hue(double a, double b) noexcept {
    const double degrees = std::atan2(b, a) / kDegree;
    return {std::hypot(a, b), a == 0.0 && b == 0.0 ? 0.0 : (degrees < 0.0 ? degrees + 360.0 : degrees)};
}

/// From the first to the second the short way round, in [-180, 180] degrees.
double hue_step(const ChromaAndHue& first, const ChromaAndHue& second) noexcept {
    if (first.chroma * second.chroma == 0.0) return 0.0;
    const double step = second.hue_degrees - first.hue_degrees;
    return step > 180.0 ? step - 360.0 : (step < -180.0 ? step + 360.0 : step);
}

/// Half-way the short way round, in degrees; that of the other if one is grey.
double mean_hue(const ChromaAndHue& first, const ChromaAndHue& second) noexcept {
    const double sum = first.hue_degrees + second.hue_degrees;
    if (first.chroma * second.chroma == 0.0) return sum;
    if (std::abs(first.hue_degrees - second.hue_degrees) <= 180.0) return 0.5 * sum;
    return sum < 360.0 ? 0.5 * (sum + 360.0) : 0.5 * (sum - 360.0);
}

}  // namespace

double difference(const Ciede2000Difference& /*method*/, const Lab& reference, const Lab& sample) noexcept {
    // a* stretched near the grey axis; eq. 2-7.
    const double mean_lab_chroma = 0.5 * (std::hypot(reference.a, reference.b) + std::hypot(sample.a, sample.b));
    const double stretch = 1.0 + 0.5 * (1.0 - seventh_power_share(mean_lab_chroma));
    const ChromaAndHue first = chroma_and_hue(stretch * reference.a, reference.b);
    const ChromaAndHue second = chroma_and_hue(stretch * sample.a, sample.b);

    // Differences; eq. 8-11.
    const double dl = sample.l - reference.l;
    const double dc = second.chroma - first.chroma;
    const double dh =
        2.0 * std::sqrt(first.chroma) * std::sqrt(second.chroma) * std::sin(0.5 * hue_step(first, second) * kDegree);

    // Weights at the means; eq. 12-21.
    const double lightness = 0.5 * (reference.l + sample.l) - 50.0;
    const double chroma = 0.5 * (first.chroma + second.chroma);
    const double hue = mean_hue(first, second);
    const double t = 1.0 - 0.17 * std::cos((hue - 30.0) * kDegree) + 0.24 * std::cos(2.0 * hue * kDegree) +
                     0.32 * std::cos((3.0 * hue + 6.0) * kDegree) - 0.20 * std::cos((4.0 * hue - 63.0) * kDegree);
    const double sl = 1.0 + 0.015 * lightness * lightness / std::sqrt(20.0 + lightness * lightness);
    const double sc = 1.0 + 0.045 * chroma;
    const double sh = 1.0 + 0.015 * chroma * t;
    const double blueness = (hue - 275.0) / 25.0;
    const double turn_degrees = 30.0 * std::exp(-blueness * blueness);
    const double rotation = -2.0 * seventh_power_share(chroma) * std::sin(2.0 * turn_degrees * kDegree);

    // Eq. 22. The form is positive definite: |rotation| < 2.
    const double ql = dl / sl, qc = dc / sc, qh = dh / sh;
    return std::sqrt(ql * ql + qc * qc + qh * qh + rotation * qc * qh);
}

}  // namespace emulsion
