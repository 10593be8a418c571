// What parallel_for adds to a body, for each index: a plain loop over the same body is the baseline of the ratios.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/parallel.h"
#include "core/random.h"

namespace emulsion {
namespace {

constexpr int kIndices = 4096;

/// About as long as `steps` times a nanosecond or two.
std::uint64_t work(int index, int steps) {
    std::uint64_t hash = 0;
    for (int step = 0; step < steps; ++step) hash = hash_combine(hash, static_cast<std::uint64_t>(index));
    return hash;
}

bool is_right(const std::vector<std::uint64_t>& results, int steps) {
    for (int i = 0; i < kIndices; ++i) {
        if (results[static_cast<std::size_t>(i)] != work(i, steps)) return false;
    }
    return true;
}

void plain_loop(benchmark::State& state) {
    const auto steps = static_cast<int>(state.range(0));
    std::vector<std::uint64_t> results(kIndices);
    for (auto _ : state) {
        for (int i = 0; i < kIndices; ++i) results[static_cast<std::size_t>(i)] = work(i, steps);
        benchmark::ClobberMemory();
    }
    if (!is_right(results, steps)) state.SkipWithError("wrong results");
    state.SetItemsProcessed(state.iterations() * kIndices);
}
BENCHMARK(plain_loop)->Arg(1)->Arg(1000)->UseRealTime()->Repetitions(5);

/// range(0): steps of a body; range(1): threads, 0 for one per hardware thread.
void parallel_loop(benchmark::State& state) {
    const auto steps = static_cast<int>(state.range(0)), threads = static_cast<int>(state.range(1));
    std::vector<std::uint64_t> results(kIndices);
    for (auto _ : state) {
        parallel_for(0, kIndices, threads, [&](int i) { results[static_cast<std::size_t>(i)] = work(i, steps); });
        benchmark::ClobberMemory();
    }
    if (!is_right(results, steps)) state.SkipWithError("wrong results");
    state.SetItemsProcessed(state.iterations() * kIndices);
}
BENCHMARK(parallel_loop)->ArgsProduct({{1, 1000}, {1, 2, 0}})->UseRealTime()->Repetitions(5);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
