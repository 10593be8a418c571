#include "film/filter_footprint.h"

#include "core/parameters.h"
#include "film/cubic_fit.h"

namespace emulsion {

namespace {

// Of the mean weight, 1.
constexpr double kCubicTolerance = 2e-6;

/// f as it is just inside the radius where it is asked at the radius.
double inside(const Filter& filter, FilterAxis axis, double offset_px) noexcept {
    const double radius = radius_px(filter, axis);
    return eval(filter, axis, std::min(std::abs(offset_px), std::nextafter(radius, 0.0)));
}

}  // namespace

FilterFootprint::FilterFootprint(const Filter& filter) : filter_(filter) {
    validate(filter);
    for (const FilterAxis axis : {FilterAxis::x, FilterAxis::y}) {
        check_range(radius_px(filter, axis), {0.0, kMostRadius_px, RangeEnd::open}, "filter for splatting: radius");
    }
    x_ = make_table(filter, FilterAxis::x);
    y_ = make_table(filter, FilterAxis::y);
}

FilterFootprint::AxisTable FilterFootprint::make_table(const Filter& filter, FilterAxis axis) {
    AxisTable table;
    table.radius_px = radius_px(filter, axis);
    table.cells_per_px = static_cast<float>(kCells / table.radius_px);
    const double width = table.radius_px / kCells;

    double half_integral = 0.0;
    constexpr int kPointsPerCell = 64;
    for (int i = 0; i < kCells * kPointsPerCell; ++i) {
        half_integral += width / kPointsPerCell * eval(filter, axis, (i + 0.5) * (width / kPointsPerCell));
    }
    table.mean_weight_scale = table.radius_px / half_integral;

    for (int i = 0; i < kCells; ++i) {
        const auto weight = [&](double t) { return table.mean_weight_scale * inside(filter, axis, (i + t) * width); };
        table.mean_square_weight += integral_of_square(weight) / kCells;
        const CubicFit fit = fit_cubic(weight);
        const auto w = [&fit](std::size_t k) { return static_cast<float>(fit.coefficient[k]); };
        table.cells.push_back({w(0), w(1), w(2), w(3), fit.worst < kCubicTolerance});
    }
    return table;
}

double FilterFootprint::weight_reference(FilterAxis axis, double offset_px) const noexcept {
    return table(axis).mean_weight_scale * inside(filter_, axis, offset_px);
}

std::size_t FilterFootprint::most_pixels(FilterAxis axis) const noexcept {
    return static_cast<std::size_t>(std::ceil(2.0 * table(axis).radius_px)) + 1;
}

PixelBounds FilterFootprint::places_that_reach(const PixelBounds& pixels) const noexcept {
    const auto down = [](double place) { return static_cast<int>(std::floor(place)); };
    const auto up = [](double place) { return static_cast<int>(std::ceil(place)); };
    return {down(pixels.x0 + 0.5 - x_.radius_px), down(pixels.y0 + 0.5 - y_.radius_px),
            up(pixels.x1 - 0.5 + x_.radius_px), up(pixels.y1 - 0.5 + y_.radius_px)};
}

PixelBounds FilterFootprint::reached_from(const PixelBounds& places) const noexcept {
    const auto begin = [](int place, double radius) { return static_cast<int>(std::floor(place - 0.5 - radius)) + 1; };
    const auto end = [](int place, double radius) { return static_cast<int>(std::floor(place - 0.5 + radius)) + 1; };
    return {begin(places.x0, x_.radius_px), begin(places.y0, y_.radius_px), end(places.x1, x_.radius_px),
            end(places.y1, y_.radius_px)};
}

}  // namespace emulsion
