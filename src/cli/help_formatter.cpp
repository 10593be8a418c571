#include "cli/help_formatter.h"

#include <algorithm>

namespace emulsion::cli {

namespace {

constexpr std::size_t kGapColumn = 30;  // where descriptions start

std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// Where the further lines of this one start.
std::size_t hanging_indent(std::string_view line, std::size_t gap_column) {
    const std::size_t indent = indent_of(line);
    const bool has_gap = indent > 0 && indent < gap_column && line.size() > gap_column && line[gap_column - 1] == ' ';
    if (has_gap) return gap_column;
    return indent == 0 ? 0 : indent + 2;
}

/// The last space up to `end` that a line may be broken at, which is none inside of a range, "(0, inf)".
std::size_t break_before(std::string_view line, std::size_t end) {
    constexpr std::size_t kLongestRange = 16;
    const std::size_t space = line.rfind(' ', end);
    const std::size_t open = line.find_last_of("([", space);
    if (space == std::string_view::npos || open == std::string_view::npos) return space;
    const std::size_t close = line.find_first_of(")]", open);
    const bool is_inside = close != std::string_view::npos && close > space && close - open < kLongestRange;
    return is_inside ? line.rfind(' ', open) : space;
}

std::string wrapped_line(std::string_view line, std::size_t columns, std::size_t gap_column) {
    const std::size_t indent = hanging_indent(line, gap_column);
    std::string text;
    std::size_t words_begin = std::max(indent_of(line), indent == gap_column ? gap_column : std::size_t{0});
    while (line.size() > columns) {
        std::size_t end = break_before(line, columns);
        if (end == std::string_view::npos || end <= words_begin) end = line.find(' ', columns);
        if (end == std::string_view::npos) break;
        text += line.substr(0, end);
        text += "\n" + std::string(indent, ' ');
        line.remove_prefix(end + 1);
        columns -= text.find('\n') == text.rfind('\n') ? indent : 0;  // from the second line on
        words_begin = 0;
    }
    return text += line;
}

class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter() { column_width(kGapColumn); }

    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        return wrapped(Formatter::make_help(app, std::move(name), mode), kHelpColumns, kGapColumn);
    }
    std::string make_option_opts(const CLI::Option* option) const override {
        const std::string& value = option->get_option_text();
        return indent_of(value) == value.size() ? "" : " " + value;
    }
};

}  // namespace

std::string wrapped(std::string_view text, std::size_t columns, std::size_t gap_column) {
    std::string lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines += wrapped_line(text.substr(0, end), columns, gap_column);
        text.remove_prefix(end);
        if (text.empty()) break;
        lines += '\n';
        text.remove_prefix(1);
    }
    return lines;
}

std::shared_ptr<CLI::FormatterBase> help_formatter() { return std::make_shared<HelpFormatter>(); }

}  // namespace emulsion::cli
