#pragma once
// A transport model, or the wish that the program finds one.

#include <string_view>
#include <variant>

#include "analysis/model_analysis.h"

namespace emulsion {

/// The cheapest model whose predicted error is within the budget.
struct AutoModel {
    ErrorBudget budget;
    bool operator==(const AutoModel&) const = default;
};

using ModelChoice = std::variant<TransportModel, AutoModel>;

/// A model as parse_transport_model() reads it, or "auto[:MEAN[,P99]]" as parse_auto() does. \throws
/// std::invalid_argument naming what was found and what was expected.
[[nodiscard]] ModelChoice parse_model_choice(std::string_view text);

}  // namespace emulsion
