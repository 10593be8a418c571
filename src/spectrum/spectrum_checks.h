#pragma once
// How the parts of a spectrum refuse what is out of range.

#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/core.h>

namespace emulsion {

[[noreturn]] inline void throw_bad_spectrum(std::string_view field, double value, std::string_view expected) {
    throw std::invalid_argument(fmt::format("{} = {}: expected {}", field, value, expected));
}

inline void require_finite(std::string_view field, double value) {
    if (!std::isfinite(value)) throw_bad_spectrum(field, value, "a finite number");
}

inline void require_positive(std::string_view field, double value) {
    if (!std::isfinite(value) || value <= 0.0) throw_bad_spectrum(field, value, "a finite number > 0");
}

}  // namespace emulsion
