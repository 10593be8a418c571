#pragma once
// By which of its two ways a stage goes, up to tone mapping: the fast one, or its twin in double precision that
// specifies it (..._reference).

#include <string_view>
#include <variant>

namespace emulsion {

struct FastPrecision {
    static constexpr std::string_view kName = "fast";
    static constexpr std::string_view kHelp = "in single precision, on all threads";
    bool operator==(const FastPrecision&) const = default;
};

/// On one thread. Each stage hands on pixels of single precision. Bloom costs what its disc's area is, for each pixel,
/// and the veil of human vision the whole picture for each pixel.
struct ReferencePrecision {
    static constexpr std::string_view kName = "reference";
    static constexpr std::string_view kHelp = "in double precision, as the sources have it; on one thread, and slow";
    bool operator==(const ReferencePrecision&) const = default;
};

/// The first is the default. core/named_value.h prints, parses and lists them.
using Precision = std::variant<FastPrecision, ReferencePrecision>;

}  // namespace emulsion
