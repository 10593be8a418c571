// Strategies for the wavelengths of a path: what the wavelengths cost beside their double-precision twin.
// docs/wavelength-sampling.md has the results, and those of bench/chart/wavelengths.cpp, which tells the errors.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {
namespace {

// Of mercury's lines on a lamp's continuum: 29% of its X + Y + Z.
WavelengthImportance lamp() {
    const LineSpectrum mercury{{{435.833, 6.0}, {546.074, 12.0}, {578.013, 9.0}}, {}};
    return wavelength_importance(sum_of(BlackbodySpectrum{3000.0}, mercury));
}

// Random numbers made beforehand: they are no part of what is timed.
class Numbers {
  public:
    Numbers() {
        Pcg32 random(1);
        for (float& number : numbers_) number = random.next_float();
    }
    float operator()() noexcept { return numbers_[next_++ % numbers_.size()]; }

  private:
    std::array<float, 4096> numbers_{};
    std::size_t next_ = 0;
};

// What is timed must also be right.
template <int N>
bool twins_agree(const WavelengthSampler& sampler) {
    Numbers a, b;
    for (int i = 0; i < 1000; ++i) {
        const auto fast = sample_wavelengths<N>(sampler, a);
        const auto exact = sample_wavelengths_reference<N>(sampler, b);
        for (std::size_t k = 0; k < N; ++k) {
            const bool near = std::abs(static_cast<double>(fast.lambda_nm[k]) - exact[k].lambda_nm) <= 1e-4 &&
                              std::abs(static_cast<double>(fast.pdf[k]) / exact[k].pdf - 1.0) <= 1e-6 &&
                              fast.line[k] == exact[k].line;
            if (!near) return false;
        }
    }
    return true;
}

std::vector<WavelengthStrategy> strategies() {
    std::vector<WavelengthStrategy> all;
    for_each_alternative<WavelengthStrategy>([&](const auto& strategy) { all.emplace_back(strategy); });
    return all;
}

// draw(sampler, numbers, N as a constant) for the strategy and N of the state.
template <class Draw>
void time_drawing(benchmark::State& state, const Draw& draw) {
    const WavelengthStrategy strategy = strategies()[static_cast<std::size_t>(state.range(0))];
    const WavelengthSampler sampler = prepare(strategy, lamp());
    state.SetLabel(to_text(strategy));
    for_each_wavelength_count([&]<int N>() {
        if (state.range(1) != N) return;
        if (!twins_agree<N>(sampler)) {
            state.SkipWithError("the fast path differs from its twin");
            return;
        }
        Numbers numbers;
        for (auto _ : state) benchmark::DoNotOptimize(draw(sampler, numbers, std::integral_constant<int, N>{}));
        using benchmark::Counter;
        state.counters["per_wavelength"] =
            Counter(N, Counter::kIsIterationInvariantRate | Counter::kInvert, Counter::kIs1000);
    });
}

void fast(benchmark::State& state) {
    time_drawing(state, []<int N>(const WavelengthSampler& sampler, Numbers& numbers, std::integral_constant<int, N>) {
        return sample_wavelengths<N>(sampler, numbers);
    });
}

void twin(benchmark::State& state) {
    time_drawing(state, []<int N>(const WavelengthSampler& sampler, Numbers& numbers, std::integral_constant<int, N>) {
        return sample_wavelengths_reference<N>(sampler, numbers);
    });
}

void every_strategy_and_count(benchmark::internal::Benchmark* registered) {
    registered->ArgNames({"strategy", "N"})->MinTime(0.02)->Repetitions(5)->ReportAggregatesOnly(true);
    for (std::size_t strategy = 0; strategy < strategies().size(); ++strategy) {
        for (const int n : kWavelengthCounts) registered->Args({static_cast<std::int64_t>(strategy), n});
    }
}

BENCHMARK(fast)->Apply(every_strategy_and_count);
BENCHMARK(twin)->Apply(every_strategy_and_count);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
