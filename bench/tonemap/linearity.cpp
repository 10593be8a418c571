// Draws what a pixel costs against how many there are, as docs/tone-mapping-cost.svg: flat lines say that cost grows
// linearly with pixels. Processor time, as other programs on the machine change that least.
//
//     bench_tonemap_linearity FILE.svg [MOST MEGAPIXELS]
//
// Prints the numbers too, as a table.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "mapping_cost.h"
#include "support/svg_chart.h"

namespace emulsion {
namespace {

constexpr int kRepeats = 5;

struct Times {
    double least_ns, median_ns, most_ns;  ///< of processor time a pixel
};

Times measure(const ToneMapper& mapper, double megapixels) {
    const int side = side_of_megapixels(megapixels);
    std::vector<double> times_ns(kRepeats);
    const std::vector<MappingCost> costs = mapping_costs_apart(mapper, side, kRepeats);
    std::transform(costs.begin(), costs.end(), times_ns.begin(),
                   [&](const MappingCost& cost) { return 1e9 * cost.cpu_seconds / side / side; });
    std::sort(times_ns.begin(), times_ns.end());
    return {times_ns.front(), times_ns[kRepeats / 2], times_ns.back()};
}

/// The least time, and a bar up to the median: others on the machine only add.
ChartSeries measured_series(const ToneMapper& mapper, const std::vector<double>& sizes) {
    const std::string text = to_text(mapper);
    ChartSeries series{text.substr(0, text.find(':')), {}};
    for (const double megapixels : sizes) {
        const Times times = measure(mapper, megapixels);
        series.points.push_back({megapixels, times.least_ns, times.median_ns});
        std::printf("| `%s` | %g | %.2f, %.2f, %.2f |\n", series.name.c_str(), megapixels, times.least_ns,
                    times.median_ns, times.most_ns);
        std::fflush(stdout);
    }
    return series;
}

void draw(const std::string& path, double most_megapixels) {
    Chart chart{.title = "Cost of tone mapping against the size of the picture",
                .x_label = "megapixels",
                .y_label = "ns of processor time a pixel",
                .x_ticks = {},
                .series = {}};
    for (const double megapixels : {1.0, 2.0, 4.0, 8.0, 16.0, 33.0, 66.0}) {
        if (megapixels <= most_megapixels) chart.x_ticks.push_back(megapixels);
    }
    std::printf("| operator | megapixels | ns of processor time a pixel: least, median, most of %d |\n|---|---|---|\n",
                kRepeats);
    for (const ToneMapper& mapper : {ToneMapper{ReinhardGlobal{}}, ToneMapper{ReinhardLocal{}},
                                     ToneMapper{HighContrast{}}, ToneMapper{Durand{}}}) {
        chart.series.push_back(measured_series(mapper, chart.x_ticks));
    }
    std::ofstream file(path);
    file << to_svg(chart);
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace
}  // namespace emulsion

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: bench_tonemap_linearity FILE.svg [MOST MEGAPIXELS]\n");
        return 2;
    }
    try {
        emulsion::draw(argv[1], argc > 2 ? std::max(std::stod(argv[2]), 2.0) : 66.0);
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_tonemap_linearity: %s\n", error.what());
        return EXIT_FAILURE;
    }
}
