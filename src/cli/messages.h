#pragma once
// What the program says to people: results on standard output; progress, warnings and errors on standard error. Where
// nobody can hear it (a full disk, a closed pipe), words on standard error are lost and change nothing else; lost words
// on standard output are a failure, found by flush_output().

#include <string_view>

namespace emulsion::cli {

/// Exit codes of the program.
inline constexpr int kDone = 0, kFailed = 1, kBadUsage = 2;

/// "emulsion: error: ..." on one line, whatever the message holds.
void print_error(std::string_view message);

/// "emulsion: warning: ..." likewise.
void print_warning(std::string_view message);

/// To standard error, as it is and at once.
void print_progress(std::string_view text);

/// To standard output, as it is.
void print_output(std::string_view text);

/// \throws std::runtime_error if anything said to standard output was lost.
void flush_output();

}  // namespace emulsion::cli
