#include "analysis/model_choice.h"

#include "core/name_key.h"
#include "core/parameters.h"

namespace emulsion {

ModelChoice parse_model_choice(std::string_view text) {
    constexpr std::string_view kBudgetMark = ":";
    const std::string_view name = text.substr(0, text.find(kBudgetMark));
    if (name_key(name) != AutoModel::kName) return parse_transport_model(text, "auto[:MEAN[,P99]]");
    AutoModel model;
    if (name.size() < text.size()) {
        const std::string_view budget = text.substr(name.size() + kBudgetMark.size());
        const std::size_t comma = budget.find(',');
        parse_number(budget.substr(0, comma), "model auto: mean", model.budget.mean);
        model.budget.p99 = 3.0 * model.budget.mean;
        if (comma != std::string_view::npos)
            parse_number(budget.substr(comma + 1), "model auto: p99", model.budget.p99);
    }
    validate(model.budget);
    return model;
}

}  // namespace emulsion
