#pragma once
// Values of options that are numbers: "8", "640x480", "0.64,0.33".

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace emulsion::cli {

/// The number that the whole text is; none if it is anything else.
template <class Number>
[[nodiscard]] std::optional<Number> number_of(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// The texts between separators: one more than there are of these.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// The numbers between separators; none if any of the texts is something else.
template <class Number>
[[nodiscard]] std::optional<std::vector<Number>> numbers_of(std::string_view text, char separator) {
    std::vector<Number> numbers;
    for (const std::string_view part : split(text, separator)) {
        const auto number = number_of<Number>(part);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

}  // namespace emulsion::cli
