#include "film/filter_sampler.h"

#include <algorithm>
#include <cmath>

#include "film/cubic_fit.h"

namespace emulsion {

namespace {

// Of the mean weight, 1.
constexpr double kCubicTolerance = 2e-6;

/// Ends of `cells` parts of the half-axis that hold the same integral of |f| each.
std::vector<double> edges_of_equal_mass(const Filter& filter, FilterAxis axis, int cells) {
    // The integral of |f| on [0, i step], by midpoints.
    constexpr int kSteps = 1 << 15;
    const double radius = radius_px(filter, axis), step = radius / kSteps;
    std::vector<double> mass(kSteps + 1);
    for (int i = 0; i < kSteps; ++i) {
        const auto at = static_cast<std::size_t>(i);
        mass[at + 1] = mass[at] + step * std::abs(eval(filter, axis, (i + 0.5) * step));
    }

    std::vector<double> edges = {0.0};
    std::size_t i = 0;
    for (int k = 1; k < cells; ++k) {
        const double wanted = mass.back() * k / cells;
        while (mass[i + 1] < wanted) ++i;
        edges.push_back((static_cast<double>(i) + (wanted - mass[i]) / (mass[i + 1] - mass[i])) * step);
    }
    edges.push_back(radius);
    return edges;
}

}  // namespace

FilterSampler::FilterSampler(const Filter& filter) : filter_(filter) {
    validate(filter);
    x_ = make_table(filter, FilterAxis::x);
    y_ = make_table(filter, FilterAxis::y);
}

FilterSampler::AxisTable FilterSampler::make_table(const Filter& filter, FilterAxis axis) {
    AxisTable table;
    table.edge_px = edges_of_equal_mass(filter, axis, kCells);

    double half_integral = 0.0;
    for (std::size_t i = 0; i < kCells; ++i) {
        constexpr int kPoints = 128;
        const double start = table.edge_px[i], step = (table.edge_px[i + 1] - start) / kPoints;
        for (int k = 0; k < kPoints; ++k) {
            half_integral += step * eval(filter, axis, start + (k + 0.5) * step);
        }
    }
    table.integral_px = 2.0 * half_integral;
    for (std::size_t i = 0; i < kCells; ++i) {
        const double start = table.edge_px[i], width = table.edge_px[i + 1] - start;
        // The density is 1 / (2 kCells width).
        const auto weight = [&](double t) {
            return eval(filter, axis, start + t * width) * kCells * width / half_integral;
        };
        table.mean_square_weight += integral_of_square(weight) / kCells;
        const CubicFit fit = fit_cubic(weight);
        const auto w = [&fit](std::size_t k) { return static_cast<float>(fit.coefficient[k]); };
        table.cells.push_back({static_cast<float>(start), static_cast<float>(width), w(0), w(1), w(2), w(3),
                               fit.worst < kCubicTolerance});
    }
    return table;
}

FilterSampler::AxisSample FilterSampler::sample_axis(FilterAxis axis, float u) const noexcept {
    // All exact for the u of random.h, multiples of 2^-24.
    const float centred = 2.0f * u - 1.0f;
    const float scaled = std::abs(centred) * static_cast<float>(kCells);
    const int index = std::clamp(static_cast<int>(scaled), 0, kCells - 1);
    const float t = scaled - static_cast<float>(index);

    const Cell& cell = table(axis).cells[static_cast<std::size_t>(index)];
    if (!cell.is_cubic) {
        const AxisReference exact = sample_axis_reference(axis, static_cast<double>(u));
        return {static_cast<float>(exact.offset_px), static_cast<float>(exact.weight)};
    }
    const float offset = std::copysign(cell.start_px + t * cell.width_px, centred);
    return {offset, cell.w0 + t * (cell.w1 + t * (cell.w2 + t * cell.w3))};
}

FilterSampler::AxisReference FilterSampler::sample_axis_reference(FilterAxis axis, double u) const noexcept {
    const AxisTable& cells = table(axis);
    const double centred = 2.0 * u - 1.0, scaled = std::abs(centred) * kCells;
    const int index = std::clamp(static_cast<int>(scaled), 0, kCells - 1);
    const double start = cells.edge_px[static_cast<std::size_t>(index)];
    const double width = cells.edge_px[static_cast<std::size_t>(index) + 1] - start;
    const double offset = std::copysign(start + (scaled - index) * width, centred);
    // The density is 1 / (2 kCells width).
    return {offset, eval(filter_, axis, offset) * 2.0 * kCells * width / cells.integral_px};
}

FilterSample FilterSampler::sample(float u, float v) const noexcept {
    if (const auto* box = std::get_if<BoxFilter>(&filter_)) {
        return {(2.0f * u - 1.0f) * box->x_radius_px, (2.0f * v - 1.0f) * box->y_radius_px, 1.0f};
    }
    const AxisSample x = sample_axis(FilterAxis::x, u), y = sample_axis(FilterAxis::y, v);
    return {x.offset_px, y.offset_px, x.weight * y.weight};
}

FilterSampler::Reference FilterSampler::sample_reference(double u, double v) const noexcept {
    if (const auto* box = std::get_if<BoxFilter>(&filter_)) {
        return {(2.0 * u - 1.0) * static_cast<double>(box->x_radius_px),
                (2.0 * v - 1.0) * static_cast<double>(box->y_radius_px), 1.0};
    }
    const AxisReference x = sample_axis_reference(FilterAxis::x, u), y = sample_axis_reference(FilterAxis::y, v);
    return {x.offset_px, y.offset_px, x.weight * y.weight};
}

double FilterSampler::pdf(FilterAxis axis, double offset_px) const noexcept {
    const double radius = radius_px(filter_, axis), distance = std::abs(offset_px);
    if (!(distance < radius)) return 0.0;
    if (std::holds_alternative<BoxFilter>(filter_)) return 0.5 / radius;
    const auto& edges = table(axis).edge_px;
    const auto end = std::upper_bound(edges.begin() + 1, edges.end() - 1, distance);
    return 0.5 / (kCells * (*end - *(end - 1)));
}

}  // namespace emulsion
