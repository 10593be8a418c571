// Strategies for the wavelengths of a path: how far one estimate of XYZ is off, by strategy, number of wavelengths and
// light. docs/wavelength-sampling.md has the table. Nothing is timed: bench/spectrum/wavelengths.cpp has the times.

#include <cmath>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

#include "chart/wavelength_estimates.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

std::vector<EstimatedLight> lights() {
    const auto tabulated = [](const char* name) {
        return EstimatedLight{name, tabulated_spectrum("illuminants_5nm", name), {}};
    };
    // Mercury's lines on a lamp's continuum: 29% of its X + Y + Z.
    return {tabulated("D65"), tabulated("FL11"), tabulated("HP1"),
            EstimatedLight{"lines", BlackbodySpectrum{3000.0}, {{435.833, 6.0}, {546.074, 12.0}, {578.013, 9.0}}}};
}

template <int N>
void print_error(const WavelengthSampler& sampler, const EstimatedLight& light) {
    Pcg32 random(N);
    const XYZd square = mean_squared_error<N>(sampler, light, exact_xyz(light), 40000, random);
    std::printf(" %.3f (%.3f, %.3f) |", std::sqrt(square.y), std::sqrt(square.x), std::sqrt(square.z));
}

void print_errors() {
    std::printf("Relative RMS error of one estimate: Y (X, Z); \"misses\" where lines can't be seen\n| strategy | N |");
    const std::vector<EstimatedLight> all = lights();
    for (const EstimatedLight& light : all) std::printf(" %s |", light.name.c_str());
    std::printf("\n| --- | ---: | --- | --- | --- | --- |\n");
    for_each_alternative<WavelengthStrategy>([&]<class Strategy>(const Strategy& strategy) {
        for_each_wavelength_count([&]<int N>() {
            std::printf("| %s | %d |", std::string(Strategy::kName).c_str(), N);
            for (const EstimatedLight& light : all) {
                if (!light.lines.empty() && !std::is_same_v<Strategy, HeroLines>) {
                    std::printf(" misses |");
                } else {
                    print_error<N>(prepare(strategy, importance_of(light)), light);
                }
            }
            std::printf("\n");
        });
    });
}

}  // namespace
}  // namespace emulsion

int main() {
    emulsion::print_errors();
    return 0;
}
