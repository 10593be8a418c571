#include "spectrum/spectral_locus.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include <fmt/core.h>

#include "spectrum/chromaticity_polygon.h"

namespace emulsion {

namespace {

// Twice the signed area that a step of the locus sweeps, seen from equal energy: negative while the hue goes from
// violet by green to red.
double swept(const Chromaticity& from, const Chromaticity& to) noexcept {
    constexpr double kThird = 1.0 / 3.0;
    return (from.x - kThird) * (to.y - kThird) - (from.y - kThird) * (to.x - kThird);
}

struct Range {
    std::size_t first = 0, last = 0;
};

// The longest run of points over which the hue moves strictly one way.
Range longest_run(const std::vector<Chromaticity>& locus) noexcept {
    Range longest, run;
    for (std::size_t i = 1; i < locus.size(); ++i) {
        if (!(swept(locus[i - 1], locus[i]) < 0.0)) run.first = i;
        run.last = i;
        if (run.last - run.first > longest.last - longest.first) longest = run;
    }
    return longest;
}

void require_finite(const char* what, const Chromaticity& point) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) return;
    throw std::invalid_argument(fmt::format("{} ({}, {}): expected finite numbers", what, point.x, point.y));
}

// A ray, and XYZ seen from it. Both functions are linear in XYZ, and are the coordinates across and along the ray times
// X + Y + Z.
struct Ray {
    Chromaticity origin;
    double dx = 0.0, dy = 0.0;

    [[nodiscard]] double across(const XYZd& xyz) const noexcept {
        const double sum = xyz.x + xyz.y + xyz.z;
        return dx * (xyz.y - origin.y * sum) - dy * (xyz.x - origin.x * sum);
    }
    [[nodiscard]] double along(const Chromaticity& point) const noexcept {
        return (dx * (point.x - origin.x) + dy * (point.y - origin.y)) / (dx * dx + dy * dy);
    }
};

}  // namespace

SpectralLocus::SpectralLocus(const Observer& observer) {
    std::vector<Chromaticity> locus;
    for (const XYZd& xyz : observer.value) {
        const double sum = xyz.x + xyz.y + xyz.z;
        if (!(sum > 0.0) || !std::isfinite(sum)) {
            throw std::invalid_argument(fmt::format("observer {}: X + Y + Z = {} at {} nm: expected a positive number",
                                                    observer.name, sum,
                                                    observer.first_nm + static_cast<int>(locus.size())));
        }
        locus.push_back(chromaticity_of(xyz));
    }
    hull_ = convex_hull(locus);
    if (hull_.size() < 3 || !(signed_distance({1.0 / 3.0, 1.0 / 3.0}) > 0.0)) {
        throw std::invalid_argument(
            fmt::format("observer {}: expected a spectral locus around equal energy", observer.name));
    }
    const Range run = longest_run(locus);
    violet_nm_ = observer.first_nm + static_cast<int>(run.first);
    const auto begin = observer.value.begin();
    xyz_.assign(begin + static_cast<std::ptrdiff_t>(run.first), begin + static_cast<std::ptrdiff_t>(run.last) + 1);
}

double SpectralLocus::signed_distance(const Chromaticity& chromaticity) const noexcept {
    return emulsion::signed_distance(hull_, chromaticity);
}

SpectralLocus::Crossing SpectralLocus::crossing(const Chromaticity& origin, const Chromaticity& through) const {
    require_finite("white", origin);
    require_finite("chromaticity", through);
    const Ray ray{origin, through.x - origin.x, through.y - origin.y};
    if (ray.dx == 0.0 && ray.dy == 0.0) {
        throw std::invalid_argument(
            fmt::format("chromaticity ({}, {}): expected another than the white's", through.x, through.y));
    }

    // Every edge of the closed polygon, the purple line last. An end that lies on the ray belongs to one side, so that
    // the ray can't slip through a corner: seen from inside, the number of crossings is odd.
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    Crossing last{Crossing::Line::spectral, kNaN, {}, 0.0};
    bool inside = false;
    for (std::size_t i = 0; i < xyz_.size(); ++i) {
        const bool is_purple = i + 1 == xyz_.size();
        const XYZd &a = xyz_[i], &b = is_purple ? xyz_.front() : xyz_[i + 1];
        const double across_a = ray.across(a), across_b = ray.across(b);
        if ((across_a >= 0.0) == (across_b >= 0.0)) continue;
        const double t = across_a / (across_a - across_b);
        const Chromaticity point = chromaticity_of((1.0 - t) * a + t * b);
        const double distance = ray.along(point);
        if (!(distance > 0.0)) continue;
        inside = !inside;
        if (distance <= last.distance) continue;
        last = {is_purple ? Crossing::Line::purple : Crossing::Line::spectral,
                is_purple ? kNaN : violet_nm_ + static_cast<double>(i) + t, point, distance};
        // Monochromatic light of the end wavelengths is no purple, on whichever side of the corner rounding puts it.
        constexpr double kRounding = 1e-10;
        if (is_purple && t < kRounding) last = {Crossing::Line::spectral, double(red_nm()), point, distance};
        if (is_purple && t > 1.0 - kRounding) last = {Crossing::Line::spectral, double(violet_nm_), point, distance};
    }
    if (!inside) {
        throw std::invalid_argument(
            fmt::format("white ({}, {}): expected a chromaticity inside the spectral locus", origin.x, origin.y));
    }
    return last;
}

const SpectralLocus& cie_1931_spectral_locus() {
    static const SpectralLocus locus(cie_1931_2deg());
    return locus;
}

}  // namespace emulsion
