#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace emulsion::cli {

/// What is wrong with a command line that `program` could not parse: the argument, what was found and what was
/// expected. Errors of our own checks say so themselves; those of CLI11 are put into these words.
[[nodiscard]] std::string usage_error_text(const CLI::App& program, const CLI::ParseError& error);

}  // namespace emulsion::cli
