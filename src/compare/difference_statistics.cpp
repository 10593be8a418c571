#include "compare/difference_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace emulsion {

namespace {

/// By nearest rank; the values, at least one, change places.
double percentile(std::vector<double>& values, int percent) {
    const std::size_t rank = (values.size() * static_cast<std::size_t>(percent) + 99) / 100;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

}  // namespace

DifferenceStatistics difference_statistics(ImageView<const double> differences) {
    DifferenceStatistics statistics;
    std::vector<double> values;
    values.reserve(differences.pixels().size());
    double sum = 0.0;
    for (int y = 0; y < differences.height(); ++y) {
        for (int x = 0; x < differences.width(); ++x) {
            const double difference = differences(x, y);
            if (std::isnan(difference)) continue;
            sum += difference;
            if (values.empty() || difference > statistics.max) {
                statistics.max = difference;
                statistics.max_x = x;
                statistics.max_y = y;
            }
            values.push_back(difference);
        }
    }
    if (values.empty()) return statistics;
    statistics.pixels = static_cast<std::int64_t>(values.size());
    statistics.mean = sum / static_cast<double>(values.size());
    statistics.p50 = percentile(values, 50);
    statistics.p99 = percentile(values, 99);
    return statistics;
}

}  // namespace emulsion
