// RGB uplifts side by side: a table of how exact, how stable under other illuminants and how smooth each method is,
// then the time of one colour and of one wavelength. docs/rgb-uplift.md records both.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "spectrum/cie76_difference.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/rgb_uplift.h"
#include "spectrum/srgb_transfer.h"

namespace emulsion {
namespace {

// --- The table

struct Statistic {
    double sum = 0.0, largest = 0.0;
    int count = 0;

    void add(double value) {
        sum += value;
        largest = std::max(largest, value);
        ++count;
    }
    [[nodiscard]] double mean() const { return count == 0 ? 0.0 : sum / count; }
};

template <class Visit>
void for_each_colour(int levels, const Visit& visit) {
    const auto linear = [levels](int i) { return decode(SrgbTransfer{}, static_cast<double>(i) / (levels - 1)); };
    for (int r = 0; r < levels; ++r) {
        for (int g = 0; g < levels; ++g) {
            for (int b = 0; b < levels; ++b) visit(RGBd{linear(r), linear(g), linear(b)});
        }
    }
}

// The grid is even in encoded sRGB, and so nearly even to the eye; in wider spaces the same curve is taken.
Statistic round_trip(const RgbUplift& uplift, const RgbSpace& space, int levels) {
    const Matrix3 matrix = xyz_from_rgb(space);
    const XYZd white = xyz_of(space.white);
    const auto lab = [&](const RGBd& rgb) {
        const auto xyz = matrix * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        return lab_from_xyz({xyz[0], xyz[1], xyz[2]}, white);
    };
    Statistic statistic;
    for_each_colour(levels, [&](const RGBd& rgb) {
        statistic.add(difference(Ciede2000Difference{}, lab(rgb), lab(uplift.rgb_of(uplift.reflectance(rgb)))));
    });
    return statistic;
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

std::vector<Spectrum> measured_reflectances() {
    std::vector<Spectrum> reflectances;
    for (const std::string_view table : {"colorchecker_reflectance", "reflectances_ampas24_5nm"}) {
        for (const std::string& name : data_table(table).column_names) {
            if (name == "wavelength") continue;
            PiecewiseLinearSpectrum reflectance = tabulated_spectrum(table, name);
            reflectance.extrapolation = Extrapolation::hold;
            reflectances.emplace_back(std::move(reflectance));
        }
    }
    return reflectances;
}

bool in_gamut(const RGBd& rgb) {
    return std::min({rgb.r, rgb.g, rgb.b}) >= 0.0 && std::max({rgb.r, rgb.g, rgb.b}) <= 1.0;
}

// How far uplifts of measured reflectances' colours get from the originals when the light changes.
Statistic drift(const RgbUplift& uplift, std::string_view illuminant_name) {
    const Spectrum illuminant = tabulated_spectrum("illuminants_5nm", illuminant_name);
    const XYZd white = xyz_of_reflectance(ConstantSpectrum{1.0}, illuminant);
    const auto lab = [&](const Spectrum& reflectance) {
        return lab_from_xyz(xyz_of_reflectance(reflectance, illuminant), white);
    };
    Statistic statistic;
    for (const Spectrum& original : measured_reflectances()) {
        const RGBd rgb = uplift.rgb_of(original);
        if (!in_gamut(rgb)) continue;
        statistic.add(difference(Ciede2000Difference{}, lab(original), lab(uplift.reflectance(rgb))));
    }
    return statistic;
}

void print_table() {
    std::printf(
        "sRGB. Round trip: CIEDE2000 under D65 over 33^3 colours. Drift: CIEDE2000 from the measured original\n"
        "under A and FL11. Slope: integral of the squared slope, 1/nm, mean and largest over 9^3 colours.\n\n"
        "%-15s %18s %16s %16s %19s\n",
        "method", "round trip", "drift A", "drift FL11", "slope");
    for_each_alternative<UpliftMethod>([&]<class Method>(const Method& method) {
        const RgbSpace& space = rgb_space("sRGB");
        const RgbUplift uplift(space, method);
        const Statistic trip = round_trip(uplift, space, 33), a = drift(uplift, "A"), fl11 = drift(uplift, "FL11");
        Statistic slope;
        for_each_colour(9, [&](const RGBd& rgb) { slope.add(squared_slope(uplift.reflectance(rgb))); });
        std::printf("%-15s %8.1e %9.1e %7.3f %8.3f %7.3f %8.3f %9.5f %9.5f\n", std::string(Method::kName).c_str(),
                    trip.mean(), trip.largest, a.mean(), a.largest, fl11.mean(), fl11.largest, slope.mean(),
                    slope.largest);
    });
    const RgbUplift uplift(rgb_space("sRGB"));
    const std::vector<Spectrum> measured = measured_reflectances();
    const auto kept = std::count_if(measured.begin(), measured.end(),
                                    [&](const Spectrum& spectrum) { return in_gamut(uplift.rgb_of(spectrum)); });
    std::printf("\nDrift: %zu measured reflectances, %td within sRGB.\n\n", measured.size(), kept);

    std::printf("Round trip in wider spaces, 9^3 colours, most saturated ones beyond any reflectance\n\n");
    for (const char* name : {"Display_P3", "Rec2020", "ACEScg_AP1"}) {
        for_each_alternative<UpliftMethod>([&]<class Method>(const Method& method) {
            try {
                const Statistic trip = round_trip(RgbUplift(rgb_space(name), method), rgb_space(name), 9);
                std::printf("%-11s %-15s %8.3f %9.3f\n", name, std::string(Method::kName).c_str(), trip.mean(),
                            trip.largest);
            } catch (const std::invalid_argument&) {
                std::printf("%-11s %-15s  can't\n", name, std::string(Method::kName).c_str());
            }
        });
    }
    std::printf("\n");
}

// --- The time

std::vector<RGBd> random_colours(std::size_t count) {
    Pcg32 random(1);
    std::vector<RGBd> colours(count);
    for (RGBd& rgb : colours) rgb = {random.next_float(), random.next_float(), random.next_float()};
    return colours;
}

// The first argument of these is the method's number.
UpliftMethod method_of(benchmark::State& state) {
    std::vector<UpliftMethod> methods;
    for_each_alternative<UpliftMethod>([&](const auto& method) { methods.emplace_back(method); });
    const UpliftMethod& method = methods[static_cast<std::size_t>(state.range(0))];
    state.SetLabel(to_text(method));
    return method;
}

void prepare_space(benchmark::State& state) {
    const UpliftMethod method = method_of(state);
    for (auto _ : state) benchmark::DoNotOptimize(RgbUplift(rgb_space("sRGB"), method));
}

void one_colour(benchmark::State& state) {
    const RgbUplift uplift(rgb_space("sRGB"), method_of(state));
    const std::vector<RGBd> colours = random_colours(256);
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(uplift.reflectance(colours[i]));
        i = (i + 1) % colours.size();
    }
}

constexpr std::array<double, 4> kLambda_nm = {423.4, 517.2, 588.8, 651.9};

// Four wavelengths, as eval takes many at once.
void four_wavelengths(benchmark::State& state) {
    const Spectrum reflectance = RgbUplift(rgb_space("sRGB"), method_of(state)).reflectance({0.7, 0.2, 0.4});
    std::array<double, 4> values{};
    for (auto _ : state) {
        eval(reflectance, kLambda_nm, values);
        benchmark::DoNotOptimize(values);
    }
}

void every_method(benchmark::internal::Benchmark* registered) {
    registered->ArgName("method")->Repetitions(5);
    for (std::size_t i = 0; i < std::variant_size_v<UpliftMethod>; ++i) registered->Arg(static_cast<std::int64_t>(i));
}

// What is timed must also be right: the table's colours are those asked for to 0.4 CIELAB.
bool table_is_right(const SigmoidTable& table) {
    const RgbSpace& space = rgb_space("sRGB");
    const RgbUplift uplift(space);
    const Matrix3 matrix = xyz_from_rgb(space);
    const auto lab = [&](const RGBd& rgb) {
        const auto xyz = matrix * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        return lab_from_xyz({xyz[0], xyz[1], xyz[2]}, xyz_of(space.white));
    };
    const std::vector<RGBd> colours = random_colours(256);
    return std::all_of(colours.begin(), colours.end(), [&](const RGBd& rgb) {
        const RGB single = {static_cast<float>(rgb.r), static_cast<float>(rgb.g), static_cast<float>(rgb.b)};
        return difference(Cie76Difference{}, lab(rgb), lab(uplift.rgb_of(sigmoid_of(table.reflectance(single))))) <=
               0.4;
    });
}

void table_lookup(benchmark::State& state) {
    const SigmoidTable table(rgb_space("sRGB"));
    if (!table_is_right(table)) {
        state.SkipWithError("the table differs from the exact solver");
        return;
    }
    std::vector<RGB> colours;
    for (const RGBd& rgb : random_colours(4096)) {
        colours.push_back({static_cast<float>(rgb.r), static_cast<float>(rgb.g), static_cast<float>(rgb.b)});
    }
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(table.reflectance(colours[i]));
        i = (i + 1) % colours.size();
    }
}

template <int N>
void table_wavelengths(benchmark::State& state) {
    SigmoidCoefficients coefficients = SigmoidTable(rgb_space("sRGB")).reflectance({0.7f, 0.2f, 0.4f});
    std::array<float, N> lambda_nm{};
    for (std::size_t i = 0; i < N; ++i) lambda_nm[i] = 400.0f + 300.0f * static_cast<float>(i) / N;
    for (auto _ : state) {
        benchmark::DoNotOptimize(coefficients);
        benchmark::DoNotOptimize(lambda_nm);
        benchmark::DoNotOptimize(eval<N>(coefficients, lambda_nm));
    }
}

BENCHMARK(prepare_space)->Apply(every_method);
BENCHMARK(one_colour)->Apply(every_method);
BENCHMARK(four_wavelengths)->Apply(every_method);
BENCHMARK(table_lookup)->Repetitions(5);
BENCHMARK(table_wavelengths<4>)->Repetitions(5);
BENCHMARK(table_wavelengths<8>)->Repetitions(5);

}  // namespace
}  // namespace emulsion

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    emulsion::print_table();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
