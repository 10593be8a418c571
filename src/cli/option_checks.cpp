#include "cli/option_checks.h"

#include <cmath>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/file_names.h"
#include "cli/number_list.h"

namespace emulsion::cli {

namespace {

std::string is_positive(const std::string& text, std::string_view expected) {
    const auto value = number_of<double>(text);
    return value && std::isfinite(*value) && *value > 0.0 ? std::string{} : found_expected(text, expected);
}

}  // namespace

std::string found_expected(std::string_view text, std::string_view expected) {
    return fmt::format("found \"{}\", expected {}", text, expected);
}

OptionCheck whole_number_check(std::uint64_t least, std::uint64_t most) {
    return [=](const std::string& text) -> std::string {
        const auto value = number_of<std::uint64_t>(text);
        // CLI11 would take 010 for 8.
        const bool is_octal = text.size() > 1 && text.front() == '0';
        if (value && !is_octal && *value >= least && *value <= most) return {};
        return found_expected(text, fmt::format("a whole number from {} to {}", least, most));
    };
}

std::string is_seconds(const std::string& text) { return is_positive(text, "a number of seconds above 0"); }

std::string is_color_difference(const std::string& text) {
    return is_positive(text, "a colour difference in CIEDE2000, above 0");
}

std::string ends_in_exr(const std::string& name) {
    if (has_extension(name, ".exr")) return {};
    return found_expected(name, "a name ending in .exr (--png writes a PNG)");
}

std::string ends_in_png(const std::string& name) {
    if (has_extension(name, ".png")) return {};
    return found_expected(name, "a name ending in .png");
}

void add_threads_option(CLI::App& command, int& threads) {
    constexpr std::uint64_t kMost = 1024;
    command.add_option("--threads", threads, "Threads, 0 to 1024; 0: one per processor [default: 0]")
        ->check(whole_number_check(0, kMost))
        ->option_text("N");
}

}  // namespace emulsion::cli
