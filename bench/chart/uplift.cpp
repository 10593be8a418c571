// RGB uplifts side by side: tables of how exact, how stable under other illuminants and how smooth each method is.
// docs/rgb-uplift.md records them. Nothing is timed: bench/spectrum/uplift.cpp has the times.

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "chart/uplift_errors.h"
#include "core/named_value.h"

namespace emulsion {
namespace {

struct Summary {
    double mean = 0.0, largest = 0.0;
};

Summary summary_of(const std::vector<double>& values) {
    Summary summary;
    for (const double value : values) {
        summary.mean += value / static_cast<double>(values.size());
        summary.largest = std::max(summary.largest, value);
    }
    return summary;
}

// Integral over the visible of the squared slope, 1/nm, by straight lines between whole nanometres.
double squared_slope(const Spectrum& reflectance) {
    double sum = 0.0, previous = eval(reflectance, kMinWavelength_nm);
    for (int lambda_nm = kMinWavelength_nm + 1; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        const double value = eval(reflectance, lambda_nm);
        sum += (value - previous) * (value - previous);
        previous = value;
    }
    return sum;
}

void print_srgb() {
    std::printf(
        "sRGB. Round trip: CIEDE2000 under D65 over 33^3 colours. Drift: CIEDE2000 from the measured original\n"
        "under A and FL11. Slope: integral of the squared slope, 1/nm, mean and largest over 9^3 colours.\n\n"
        "%-15s %18s %16s %16s %19s\n",
        "method", "round trip", "drift A", "drift FL11", "slope");
    for_each_alternative<UpliftMethod>([&]<class Method>(const Method& method) {
        const RgbSpace& space = rgb_space("sRGB");
        const RgbUplift uplift(space, method);
        const Summary trip = summary_of(round_trips(uplift, space, 33)), a = summary_of(drifts(uplift, "A")),
                      fl11 = summary_of(drifts(uplift, "FL11"));
        std::vector<double> slopes;
        for_each_colour(9, [&](const RGBd& rgb) { slopes.push_back(squared_slope(uplift.reflectance(rgb))); });
        const Summary slope = summary_of(slopes);
        std::printf("%-15s %8.1e %9.1e %7.3f %8.3f %7.3f %8.3f %9.5f %9.5f\n", std::string(Method::kName).c_str(),
                    trip.mean, trip.largest, a.mean, a.largest, fl11.mean, fl11.largest, slope.mean, slope.largest);
    });
    const std::size_t kept = drifts(RgbUplift(rgb_space("sRGB")), "A").size();
    std::printf("\nDrift: %zu measured reflectances, %zu within sRGB.\n\n", measured_reflectances().size(), kept);
}

void print_wider_spaces() {
    std::printf("Round trip in wider spaces, 9^3 colours, most saturated ones beyond any reflectance\n\n");
    for (const char* name : {"Display_P3", "Rec2020", "ACEScg_AP1"}) {
        for_each_alternative<UpliftMethod>([&]<class Method>(const Method& method) {
            try {
                const Summary trip = summary_of(round_trips(RgbUplift(rgb_space(name), method), rgb_space(name), 9));
                std::printf("%-11s %-15s %8.3f %9.3f\n", name, std::string(Method::kName).c_str(), trip.mean,
                            trip.largest);
            } catch (const std::invalid_argument&) {
                std::printf("%-11s %-15s  can't\n", name, std::string(Method::kName).c_str());
            }
        });
    }
}

}  // namespace
}  // namespace emulsion

int main() {
    emulsion::print_srgb();
    emulsion::print_wider_spaces();
    return 0;
}
