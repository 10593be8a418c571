#include "film/filter_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace emulsion {

FilterSampler::FilterSampler(const Filter& filter) : filter_(filter) {
    validate(filter);
    x_ = make_table(filter, FilterAxis::x);
    y_ = make_table(filter, FilterAxis::y);
}

FilterSampler::AxisTable FilterSampler::make_table(const Filter& filter, FilterAxis axis) {
    // Integrals of f and |f| from the centre outwards, Simpson's rule in each of many steps.
    constexpr int kSteps = 1 << 15;
    const double radius = radius_px(filter, axis), step = radius / kSteps;
    std::vector<double> mass(kSteps + 1);  // of |f| on [0, i * step]
    double integral = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double a = eval(filter, axis, i * step), b = eval(filter, axis, (i + 0.5) * step),
                     c = i + 1 < kSteps ? eval(filter, axis, (i + 1) * step) : b;
        integral += step / 6.0 * (a + 4.0 * b + c);
        mass[static_cast<std::size_t>(i) + 1] =
            mass[static_cast<std::size_t>(i)] + step / 6.0 * (std::abs(a) + 4.0 * std::abs(b) + std::abs(c));
    }
    if (!(integral > 1e-6 * mass.back())) {
        throw std::invalid_argument("filter: its integral along an axis is " + std::to_string(2.0 * integral) +
                                    " px, expected a number > 0 (and not a mere residue of its lobes)");
    }

    // The half on the right, cut into parts of equal mass; the half on the left is its mirror image.
    constexpr int kHalf = kCells / 2;
    AxisTable result;
    result.integral_px = 2.0 * integral;
    std::size_t i = 0;
    for (int k = 1; k < kHalf; ++k) {
        const double wanted = mass.back() * k / kHalf;
        while (mass[i + 1] < wanted) ++i;
        const double edge = (static_cast<double>(i) + (wanted - mass[i]) / (mass[i + 1] - mass[i])) * step;
        result.edge_px[kHalf + k] = edge;
        result.edge_px[kHalf - k] = -edge;
    }
    result.edge_px.front() = -radius;
    result.edge_px.back() = radius;
    return result;
}

FilterSampler::AxisSample FilterSampler::sample_axis(FilterAxis axis, float u) const noexcept {
    const AxisTable& cells = table(axis);
    const double scaled = static_cast<double>(u) * kCells;
    const auto cell = static_cast<std::size_t>(std::clamp(static_cast<int>(scaled), 0, kCells - 1));
    const double start = cells.edge_px[cell], width = cells.edge_px[cell + 1] - start;
    const double offset = start + (scaled - static_cast<double>(cell)) * width;
    // One over the density is kCells * width.
    return {offset, eval(filter_, axis, offset) * width * kCells / cells.integral_px};
}

FilterSample FilterSampler::sample(float u, float v) const noexcept {
    if (const auto* box = std::get_if<BoxFilter>(&filter_)) {
        return {(2.0f * u - 1.0f) * box->x_radius_px, (2.0f * v - 1.0f) * box->y_radius_px, 1.0f};
    }
    const AxisSample x = sample_axis(FilterAxis::x, u), y = sample_axis(FilterAxis::y, v);
    return {static_cast<float>(x.offset_px), static_cast<float>(y.offset_px), static_cast<float>(x.weight * y.weight)};
}

double FilterSampler::pdf(FilterAxis axis, double offset_px) const noexcept {
    const double radius = radius_px(filter_, axis);
    if (!(std::abs(offset_px) < radius)) return 0.0;
    if (std::holds_alternative<BoxFilter>(filter_)) return 0.5 / radius;
    const auto& edges = table(axis).edge_px;
    const auto end = std::upper_bound(edges.begin() + 1, edges.end() - 1, offset_px);
    return 1.0 / (kCells * (*end - *(end - 1)));
}

}  // namespace emulsion
