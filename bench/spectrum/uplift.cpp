// RGB uplifts: the time of one colour and of one wavelength. docs/rgb-uplift.md records it, and what
// bench/chart/uplift.cpp finds of how exact they are.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "spectrum/cie76_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/rgb_uplift.h"

namespace emulsion {
namespace {

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

BENCHMARK_MAIN();
