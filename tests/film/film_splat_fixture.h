#pragma once
// What the tests of splatting share.

#include <cmath>

#include "film/film_options.h"
#include "film/filter.h"

namespace emulsion::testing {

/// What is to be seen at a place: smooth, and of a different size in each direction.
inline double scene(double x_px, double y_px) { return 1.0 + std::sin(0.9 * x_px) * std::cos(0.6 * y_px); }

/// The integral of the scene with the filter about a pixel's centre, over that of the filter; by midpoints.
inline double filtered_scene(const Filter& filter, int x, int y) {
    constexpr int kSteps = 256;
    const double x_radius = radius_px(filter, FilterAxis::x), y_radius = radius_px(filter, FilterAxis::y);
    double sum = 0.0, weights = 0.0;
    for (int j = 0; j < kSteps; ++j) {
        const double y_offset = y_radius * (2.0 * (j + 0.5) / kSteps - 1.0);
        const double y_weight = eval(filter, FilterAxis::y, y_offset);
        for (int i = 0; i < kSteps; ++i) {
            const double x_offset = x_radius * (2.0 * (i + 0.5) / kSteps - 1.0);
            const double weight = y_weight * eval(filter, FilterAxis::x, x_offset);
            sum += weight * scene(x + 0.5 + x_offset, y + 0.5 + y_offset);
            weights += weight;
        }
    }
    return sum / weights;
}

inline FilmOptions splatted(int width_px, int height_px, const Filter& filter) {
    return {.width_px = width_px, .height_px = height_px, .filter = filter, .filter_use = FilterUse::splatted};
}

}  // namespace emulsion::testing
