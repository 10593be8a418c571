#pragma once
// Benchmarks of every alternative of a variant of named values.

#include <cstdint>
#include <string>
#include <variant>

#include <benchmark/benchmark.h>

#include "core/named_value.h"

namespace emulsion {

/// The alternative whose number is the benchmark's argument; its name becomes the label.
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
