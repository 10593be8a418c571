#pragma once
// What the program says to people: errors and warnings on standard error, one line each.

#include <string_view>

namespace emulsion::cli {

/// Exit codes of the program.
inline constexpr int kDone = 0, kFailed = 1, kBadUsage = 2;

/// "emulsion: error: ..." on one line, whatever the message holds.
void print_error(std::string_view message);

/// "emulsion: warning: ..." likewise.
void print_warning(std::string_view message);

}  // namespace emulsion::cli
