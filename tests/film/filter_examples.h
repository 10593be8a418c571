#pragma once
// Filters to test: every alternative of the variant, with its default radii and with others.

#include <string>
#include <variant>
#include <vector>

#include "film/filter.h"

namespace emulsion::testing {

[[nodiscard]] inline std::vector<Filter> example_filters() {
    std::vector<Filter> filters;
    for_each_alternative<Filter>([&](auto filter) {
        filters.push_back(filter);
        filter.x_radius_px = 0.7f;
        filter.y_radius_px = 3.3f;
        filters.push_back(filter);
    });
    filters.insert(filters.end(), {GaussianFilter{2.0f, 1.0f, 1.0f}, MitchellFilter{2.0f, 3.0f, 0.0f, 0.5f},
                                   MitchellFilter{2.0f, 2.0f, 1.0f, 0.0f}, LanczosSincFilter{3.0f, 2.0f, 3.0f}});
    return filters;
}

[[nodiscard]] inline std::string name_of(const Filter& filter) { return to_text(filter); }

}  // namespace emulsion::testing
