#include "film/filter_footprint.h"

#include <limits>

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

/// 2 radius / the integral of f, by midpoints, at least 32 to a pixel.
double mean_weight_scale(const Filter& filter, FilterAxis axis) {
    const double radius = radius_px(filter, axis);
    const int points = std::max(1 << 15, static_cast<int>(32.0 * radius));
    double sum = 0.0;
    for (int i = 0; i < points; ++i) sum += eval(filter, axis, (i + 0.5) * (radius / points));
    return points / sum;
}

}  // namespace

FilterFootprint::FilterFootprint(const Filter& filter) : filter_(filter) {
    validate(filter);
    for (const FilterAxis axis : {FilterAxis::x, FilterAxis::y}) {
        check_range(radius_px(filter, axis), {0.0, kMostRadius_px, RangeEnd::open}, "filter for splatting: radius");
    }
    x_ = make_table(FilterAxis::x);
    y_ = make_table(FilterAxis::y);
}

FilterFootprint::AxisTable FilterFootprint::make_table(FilterAxis axis) const {
    AxisTable table;
    table.radius_px = radius_px(filter_, axis);
    table.mean_weight_scale = mean_weight_scale(filter_, axis);

    // Enough for cubics, and few enough for the first cache. An even number to a pixel: the edges of filters of whole
    // radii are at pixels' centres.
    constexpr double kCellsPerRadius = 128.0, kMostPerPixel = 128.0;
    const double per_px = 2.0 * std::ceil(0.5 * std::min(kCellsPerRadius / table.radius_px, kMostPerPixel));
    table.cells_per_px = static_cast<float>(per_px);

    // From anywhere in pixel 0, places 0 to 1.
    table.first = static_cast<int>(std::floor(-0.5 - table.radius_px)) + 1;
    const int end = static_cast<int>(std::floor(0.5 + table.radius_px)) + 1;
    table.row = (static_cast<std::size_t>(end - table.first) + 3) / 4 * 4;
    table.last_cell = static_cast<int>(per_px) - 1;
    for (int i = 0; i <= table.last_cell; ++i) add_cell(table, axis, i / per_px, 1.0 / per_px);

    constexpr int kPanels = 512;
    for (int i = 0; i < kPanels; ++i) {
        table.mean_square_weight +=
            integral_of_square([&](double t) {
                return table.mean_weight_scale * inside(filter_, axis, (i + t) * (table.radius_px / kPanels));
            }) /
            kPanels;
    }
    return table;
}

void FilterFootprint::add_cell(AxisTable& table, FilterAxis axis, double begin, double width) const {
    bool is_good = true;
    std::vector<float> coefficients(4 * table.row);
    for (std::size_t k = 0; k < table.row; ++k) {
        // A pixel that is out of reach from all of the cell has weights that nobody reads; past the radius, so have the
        // others, and their cubics go on as they like.
        const double centre = table.first + static_cast<int>(k) + 0.5;
        const double distance = std::max({0.0, begin - centre, centre - (begin + width)});
        if (distance >= table.radius_px) continue;
        const CubicFit fit = fit_cubic(
            [&](double t) { return table.mean_weight_scale * inside(filter_, axis, centre - (begin + t * width)); });
        is_good = is_good && fit.worst < kCubicTolerance;
        for (std::size_t i = 0; i < 4; ++i) {
            coefficients[k / 4 * 16 + 4 * i + k % 4] = static_cast<float>(fit.coefficient[i]);
        }
    }
    if (!is_good) coefficients[0] = std::numeric_limits<float>::quiet_NaN();
    table.coefficients.insert(table.coefficients.end(), coefficients.begin(), coefficients.end());
}

const float* FilterFootprint::weights_by_reference(FilterAxis axis, float place_px, Reach reached,
                                                   float* weights) const noexcept {
    for (int i = reached.begin; i < reached.end; ++i) {
        weights[i - reached.begin] =
            static_cast<float>(weight_reference(axis, i + 0.5 - static_cast<double>(place_px)));
    }
    return weights;
}

double FilterFootprint::weight_reference(FilterAxis axis, double offset_px) const noexcept {
    return table(axis).mean_weight_scale * inside(filter_, axis, offset_px);
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
