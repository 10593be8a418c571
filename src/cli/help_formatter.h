#pragma once
// `--help` in lines that fit on a terminal.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace emulsion::cli {

/// Columns of a line of help, at most, but for a word that alone is longer.
inline constexpr std::size_t kHelpColumns = 100;

/// The text with lines of more than `columns` broken between words. What a line goes on with stands below its text: two
/// columns further in than it, or, where it starts with a name, below what follows the gap at `gap_column`.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t columns, std::size_t gap_column);

/// Help in kHelpColumns, with each option's own word for its value and nothing else of CLI11's beside its name.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

}  // namespace emulsion::cli
