#include "analysis/model_choice.h"

namespace emulsion {

ModelChoice parse_model_choice(std::string_view text) {
    if (const auto budget = parse_auto(text, "model")) return AutoModel{*budget};
    return parse_transport_model(text, "auto[:MEAN[,P99]]");
}

}  // namespace emulsion
