#pragma once
// Benchmarks of every alternative of a variant of named values.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/named_value.h"

namespace emulsion {

/// The numbers of those that are wanted.
template <NamedVariant Variant, class IsWanted>
std::vector<std::int64_t> numbers_of(const IsWanted& is_wanted) {
    std::vector<std::int64_t> numbers;
    std::int64_t number = 0;
    for_each_alternative<Variant>([&](const auto& alternative) {
        if (is_wanted(Variant{alternative})) numbers.push_back(number);
        ++number;
    });
    return numbers;
}

/// The alternative whose number is the benchmark's first argument; its name becomes the label.
template <NamedVariant Variant>
Variant alternative_of_range(benchmark::State& state) {
    Variant found;
    std::int64_t number = 0;
    for_each_alternative<Variant>([&](const auto& chosen) {
        if (number++ != state.range(0)) return;
        found = chosen;
        state.SetLabel(std::string(chosen.kName));
    });
    return found;
}

}  // namespace emulsion
