#pragma once
// How large a colour error may be, where the program is to find the cheapest way that is good enough.

#include <optional>
#include <string_view>

namespace emulsion {

/// The colour error that a picture may have, CIEDE2000 by the rule of spectrum/viewing_conditions.h.
struct ErrorBudget {
    double mean = 1.0;  ///< over pixels; finite, >= 0
    double p99 = 3.0;   ///< that 99 in 100 pixels don't exceed; finite, >= 0
    bool operator==(const ErrorBudget&) const = default;
};

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const ErrorBudget& budget);

/// Whether errors of these, CIEDE2000, are good enough; both ends of the range belong to it. NaN is not.
[[nodiscard]] constexpr bool is_within(double mean, double p99, const ErrorBudget& budget) noexcept {
    return mean <= budget.mean && p99 <= budget.p99;
}

/// What leaves a choice to the program.
inline constexpr std::string_view kAutoChoice = "auto";

/// The budget of "auto[:MEAN[,P99]]", the name as names are compared (core/name_key.h); P99 is three times MEAN unless
/// it is given. None for a text of another name.
/// \param what "model": the choice, for messages
/// \throws std::invalid_argument naming what was found and what was expected.
[[nodiscard]] std::optional<ErrorBudget> parse_auto(std::string_view text, std::string_view what);

}  // namespace emulsion
