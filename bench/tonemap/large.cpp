// What each operator takes for a large picture: time, processor time and peak memory, mapped in place on all threads,
// the best of three.
//
//     bench_tonemap_large [MEGAPIXELS [OPERATOR...]]
//
// 400 megapixels of XYZ are 4.5 GiB; `ulimit -v 12582912` before it holds every operator to 12 GiB. Exit code 1: one
// failed, or what came out was not sound.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "mapping_cost.h"

namespace emulsion {
namespace {

/// All if none is named.
std::vector<ToneMapper> chosen_mappers(const std::vector<std::string>& names) {
    std::vector<ToneMapper> mappers(names.size());
    std::transform(names.begin(), names.end(), mappers.begin(),
                   [](const std::string& name) { return parse_named<ToneMapper>(name, "tonemap"); });
    if (names.empty()) {
        for_each_alternative<ToneMapper>([&](const auto& mapper) { mappers.emplace_back(mapper); });
    }
    return mappers;
}

/// Others on the machine only add to times: the least of three counts, and the most is shown beside it.
void print_row(const std::string& name, double pixels, const std::vector<MappingCost>& costs) {
    const auto by_cpu = [](const MappingCost& a, const MappingCost& b) { return a.cpu_seconds < b.cpu_seconds; };
    const auto by_time = [](const MappingCost& a, const MappingCost& b) { return a.seconds < b.seconds; };
    const auto [least, most] = std::minmax_element(costs.begin(), costs.end(), by_cpu);
    const double seconds = std::min_element(costs.begin(), costs.end(), by_time)->seconds;
    const double peak_bytes = costs.back().peak_bytes;
    std::printf("| `%s` | %.2f | %.2f (%.2f) | %.0f | %.0f | %.2f | %.2f |\n", name.c_str(), seconds,
                least->cpu_seconds, most->cpu_seconds, 1e-6 * pixels / seconds, 1e-6 * pixels / least->cpu_seconds,
                peak_bytes / 0x1p30, peak_bytes / (sizeof(XYZ) * pixels));
    std::fflush(stdout);
}

/// Whether all went well.
bool print_costs(double megapixels, const std::vector<ToneMapper>& mappers) {
    const int side = side_of_megapixels(megapixels);
    const double pixels = 1.0 * side * side;
    std::printf("%d x %d pixels, a picture of %.2f GiB\n\n", side, side, sizeof(XYZ) * pixels / 0x1p30);
    std::printf("| operator | s | CPU s (most) | Mpix/s | Mpix per CPU s | peak GiB | peak in pictures |\n");
    std::printf("|---|---|---|---|---|---|---|\n");
    bool all_well = true;
    for (const ToneMapper& mapper : mappers) {
        const std::string text = to_text(mapper);
        try {
            print_row(text.substr(0, text.find(':')), pixels, mapping_costs_apart(mapper, side, 3));
        } catch (const std::exception& error) {
            std::printf("%s\n", error.what());
            all_well = false;
        }
    }
    return all_well;
}

}  // namespace
}  // namespace emulsion

int main(int argc, char** argv) {
    try {
        const double megapixels = argc > 1 ? std::stod(argv[1]) : 400.0;
        const std::vector<std::string> names(argv + (argc > 1 ? 2 : argc), argv + argc);
        return emulsion::print_costs(megapixels, emulsion::chosen_mappers(names)) ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_tonemap_large: %s\n", error.what());
        return 2;
    }
}
