#include "compare/difference_statistics.h"

#include <cmath>
#include <vector>

#include "core/nearest_rank.h"

namespace emulsion {

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
    statistics.p50 = nearest_rank(values, 50);
    statistics.p99 = nearest_rank(values, 99);
    return statistics;
}

}  // namespace emulsion
