#pragma once
// What the values of options may be, each said in one way: found "...", expected ...

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace emulsion::cli {

/// found "TEXT", expected EXPECTED
[[nodiscard]] std::string found_expected(std::string_view text, std::string_view expected);

/// For CLI::Option::check: empty if the text will do, else what is wrong with it.
using OptionCheck = std::function<std::string(const std::string&)>;

/// Digits alone, of a number in [least, most].
[[nodiscard]] OptionCheck whole_number_check(std::uint64_t least, std::uint64_t most);

// A finite number above 0, of one unit or the other.
[[nodiscard]] std::string is_seconds(const std::string& text);
[[nodiscard]] std::string is_color_difference(const std::string& text);

/// A name ending in .exr.
[[nodiscard]] std::string ends_in_exr(const std::string& name);

/// A name ending in .png: its bytes would be those of a PNG under any other.
[[nodiscard]] std::string ends_in_png(const std::string& name);

/// Adds --threads; `threads` must outlive the parsing.
void add_threads_option(CLI::App& command, int& threads);

}  // namespace emulsion::cli
