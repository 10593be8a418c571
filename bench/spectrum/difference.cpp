// Colour differences, the matrix of a chromatic adaptation, and ICtCp, one at a time: each is verified first. All are
// in double precision and have no faster form; reading the colours alone is what they are measured beside.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/named_value.h"
#include "core/random.h"
#include "spectrum/chromatic_adaptation.h"
#include "spectrum/color_difference.h"
#include "spectrum/itp_difference.h"
#include "support/alternatives.h"

namespace emulsion {
namespace {

constexpr std::size_t kColours = 1024;
constexpr XYZd kA = {1.09850, 1.0, 0.35585}, kD65 = {0.95047, 1.0, 1.08883};

std::vector<Lab> colours() {
    Pcg32 random(3);
    const auto unit = [&] { return static_cast<double>(random.next_float()); };
    std::vector<Lab> all(kColours);
    for (Lab& lab : all) lab = {100.0 * unit(), 160.0 * unit() - 80.0, 160.0 * unit() - 80.0};
    return all;
}

template <NamedVariant Variant>
void every_alternative(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgName("alternative")->DenseRange(0, static_cast<int>(std::variant_size_v<Variant>) - 1);
    benchmark->Repetitions(5)->ReportAggregatesOnly();
}

/// Times visit(i, i + 1) of a ring of colours, one for each iteration.
template <class Visit>
void time_pairs(benchmark::State& state, const Visit& visit) {
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(visit(i, (i + 1) % kColours));
        i = (i + 1) % kColours;
    }
}

void reading_alone(benchmark::State& state) {
    const std::vector<Lab> all = colours();
    time_pairs(state, [&](std::size_t i, std::size_t j) { return all[i].l - all[j].l; });
}

void lab_difference(benchmark::State& state) {
    const auto method = alternative_of_range<ColorDifference>(state);
    const std::vector<Lab> all = colours();
    for (const Lab& lab : all) {
        const double step = difference(method, lab, {lab.l + 1.0, lab.a, lab.b});
        if (difference(method, lab, lab) != 0.0 || !(step > 0.2 && step < 3.0)) return state.SkipWithError("wrong");
    }
    time_pairs(state, [&](std::size_t i, std::size_t j) { return difference(method, all[i], all[j]); });
}

void itp_difference_of_xyz(benchmark::State& state) {
    const std::vector<Lab> all = colours();
    std::vector<XYZd> xyz;
    xyz.reserve(all.size());
    for (const Lab& lab : all) xyz.push_back({lab.l + 0.1 * lab.a + 9.0, lab.l + 1.0, lab.l + 0.1 * lab.b + 9.0});
    for (const XYZd& colour : xyz) {
        const XYZd back = xyz_from_ictcp(ictcp_from_xyz(colour));
        if (!(std::abs(back.y - colour.y) < 1e-10)) return state.SkipWithError("does not come back");
    }
    time_pairs(state, [&](std::size_t i, std::size_t j) {
        return difference(ItpDifference{}, ictcp_from_xyz(xyz[i]), ictcp_from_xyz(xyz[j]));
    });
}

void adaptation(benchmark::State& state) {
    const auto method = alternative_of_range<ChromaticAdaptation>(state);
    const auto white = adaptation_matrix(method, kA, kD65) * std::array<double, 3>{kA.x, kA.y, kA.z};
    if (!(std::abs(white[2] - kD65.z) < 1e-12)) return state.SkipWithError("white is not mapped to white");
    XYZd from = kA;
    for (auto _ : state) {
        benchmark::DoNotOptimize(from);
        benchmark::DoNotOptimize(adaptation_matrix(method, from, kD65));
    }
}

BENCHMARK(reading_alone)->Repetitions(5)->ReportAggregatesOnly();
BENCHMARK(lab_difference)->Apply(every_alternative<ColorDifference>);
BENCHMARK(itp_difference_of_xyz)->Repetitions(5)->ReportAggregatesOnly();
BENCHMARK(adaptation)->Apply(every_alternative<ChromaticAdaptation>);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
