#include "film/filter_footprint.h"

#include <bit>

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

const Filter& checked(const Filter& filter) {
    validate(filter);
    for (const FilterAxis axis : {FilterAxis::x, FilterAxis::y}) {
        check_range(radius_px(filter, axis), {0.0, FilterFootprint::kMostRadius_px, RangeEnd::open},
                    "filter for splatting: radius");
    }
    return filter;
}

}  // namespace

FilterFootprint::FilterFootprint(const Filter& filter)
    : filter_(checked(filter)),
      x_(make_table(FilterAxis::x)),
      y_(make_table(FilterAxis::y)),
      cells_per_px_{x_.cells_per_px, y_.cells_per_px, 0.0f, 0.0f} {}

FilterFootprint::AxisTable FilterFootprint::make_table(FilterAxis axis) const {
    AxisTable table;
    table.radius_px = radius_px(filter_, axis);
    table.mean_weight_scale = mean_weight_scale(filter_, axis);

    // Enough for cubics, and few enough for the first cache. An even number to a pixel: the edges of filters of whole
    // radii are at pixels' centres.
    constexpr double kCellsPerRadius = 128.0, kMostPerPixel = 128.0;
    const double per_px = 2.0 * std::ceil(0.5 * std::min(kCellsPerRadius / table.radius_px, kMostPerPixel));
    table.cells_per_px = static_cast<float>(per_px);
    if (const auto cells = static_cast<std::uint32_t>(per_px); std::has_single_bit(cells)) {
        table.cell_mask = cells - 1;
        table.cell_bits = static_cast<std::uint32_t>(std::countr_zero(cells));
    }
    int most = 0;
    for (int i = 0; i < static_cast<int>(per_px); ++i) {
        table.cells.push_back(make_cell(i / per_px, (i + 1) / per_px, table.radius_px));
        most = std::max(most, table.cells.back().reach.end - table.cells.back().reach.begin);
    }
    table.row = (static_cast<std::size_t>(most) + 3) / 4 * 4;
    for (std::size_t i = 0; i < table.cells.size(); ++i) add_cubics(table, axis, i);

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

FilterFootprint::Cell FilterFootprint::make_cell(double begin, double end, double radius) noexcept {
    // From its first place, and from those just before its end.
    const Reach first = reach_in_pixel_0(begin, radius);
    const Reach last = {static_cast<int>(std::ceil(end - 0.5 - radius)),
                        static_cast<int>(std::ceil(end - 0.5 + radius))};
    return {{first.begin, last.end}, first.begin != last.begin || first.end != last.end};
}

FilterFootprint::Reach FilterFootprint::reach_in_pixel_0(double place, double radius) noexcept {
    return {static_cast<int>(std::floor(place - 0.5 - radius)) + 1,
            static_cast<int>(std::floor(place - 0.5 + radius)) + 1};
}

FilterFootprint::Reach FilterFootprint::reach_from_edge_cell(const AxisTable& table, Phase phase) noexcept {
    // What the cell has no weights for is a rounding away from its edge, and has none.
    const Reach reach = reach_in_pixel_0(static_cast<double>(phase.in_pixel), table.radius_px);
    const Reach& most = table.cells[phase.cell].reach;
    return {phase.pixel + std::max(reach.begin, most.begin), phase.pixel + std::min(reach.end, most.end)};
}

void FilterFootprint::add_cubics(AxisTable& table, FilterAxis axis, std::size_t cell) const {
    const auto cells = static_cast<double>(table.cells.size());
    const double begin = static_cast<double>(cell) / cells, width = 1.0 / cells;
    const Reach& reach = table.cells[cell].reach;
    bool is_good = true;
    std::vector<float> coefficients(4 * table.row);
    for (int pixel = reach.begin; pixel < reach.end; ++pixel) {
        // Past the radius, weights have no reader, and cubics go on as they like.
        const double centre = pixel + 0.5;
        const CubicFit fit = fit_cubic(
            [&](double t) { return table.mean_weight_scale * inside(filter_, axis, centre - (begin + t * width)); });
        is_good = is_good && fit.worst < kCubicTolerance;
        const auto k = static_cast<std::size_t>(pixel - reach.begin);
        for (std::size_t i = 0; i < 4; ++i) {
            coefficients[k / 4 * 16 + 4 * i + k % 4] = static_cast<float>(fit.coefficient[i]);
        }
    }
    table.cells[cell].has_cubics = is_good;
    table.cells[cell].is_quick_four = is_good && !table.cells[cell].has_edge && reach.end - reach.begin == 4 &&
                                      table.row == 4 && table.cell_mask != 0;
    table.coefficients.insert(table.coefficients.end(), coefficients.begin(), coefficients.end());
}

FilterFootprint::Weights FilterFootprint::unusual_weights(FilterAxis axis, float place_px,
                                                          float* weights) const noexcept {
    const Reach reached = reach(axis, place_px);
    const AxisTable& axis_table = table(axis);
    const Phase phase = axis_table.phase(place_px);
    const Cell& cell = axis_table.cells[phase.cell];
    if (cell.has_cubics) {
        axis_table.cubics(phase.cell, phase.t, weights);
        return {reached, weights + (reached.begin - phase.pixel - cell.reach.begin)};
    }
    for (int i = reached.begin; i < reached.end; ++i) {
        weights[i - reached.begin] =
            static_cast<float>(weight_reference(axis, i + 0.5 - static_cast<double>(place_px)));
    }
    return {reached, weights};
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
