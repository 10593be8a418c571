#include "spectrum/error_budget.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "core/name_key.h"
#include "core/parameters.h"

namespace emulsion {

void validate(const ErrorBudget& budget) {
    for (const auto& [name, value] : {std::pair("mean", budget.mean), std::pair("p99", budget.p99)}) {
        if (std::isfinite(value) && value >= 0.0) continue;
        throw std::invalid_argument(fmt::format("error budget: {} = {}: must be finite and at least 0", name, value));
    }
}

std::optional<ErrorBudget> parse_auto(std::string_view text, std::string_view what) {
    const std::string_view name = text.substr(0, text.find(':'));
    if (name_key(name) != kAutoChoice) return std::nullopt;
    ErrorBudget budget;
    if (name.size() < text.size()) {
        const std::string_view numbers = text.substr(name.size() + 1);
        const std::size_t comma = numbers.find(',');
        parse_number(numbers.substr(0, comma), std::string(what) + " auto: mean", budget.mean);
        budget.p99 = 3.0 * budget.mean;
        if (comma != std::string_view::npos) {
            parse_number(numbers.substr(comma + 1), std::string(what) + " auto: p99", budget.p99);
        }
    }
    validate(budget);
    return budget;
}

}  // namespace emulsion
