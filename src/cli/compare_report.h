#pragma once
// What `emulsion compare` has to say.

#include <optional>
#include <string>
#include <vector>

#include "cli/compare_settings.h"
#include "cli/info_report.h"
#include "compare/compare.h"

namespace emulsion::cli {

struct CompareReport {
    const CompareSettings& settings;
    const ComparedPicture& a;
    const ComparedPicture& b;
    const Comparison& comparison;
};

[[nodiscard]] InfoReport report_of(const CompareReport& in);

/// What of the limits is exceeded, one sentence each; empty: nothing.
[[nodiscard]] std::vector<std::string> exceeded(const DifferenceLimits& limits, const Comparison& comparison);

}  // namespace emulsion::cli
