#include "core/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <stdexcept>
#include <system_error>

#include "core/name_key.h"

namespace emulsion {

namespace {

template <class T>
std::string shortest_text(T value) {
    std::array<char, 64> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string joined(std::span<const ParameterWord> words, std::string_view between) {
    std::string text;
    for (const ParameterWord& choice : words) {
        if (!text.empty()) text += between;
        text += choice.word;
    }
    return text;
}

/// "not a number", or "neither auto nor a number".
std::string refusal_of_text(std::string_view number, std::span<const ParameterWord> special) {
    if (special.empty()) return "not " + std::string(number);
    return "neither " + joined(special, " nor ") + " nor " + std::string(number);
}

template <class T>
void parse_whole_text(std::string_view text, std::string_view what, T& value, std::span<const ParameterWord> special) {
    const std::string shown = std::string(what) + " = \"" + std::string(text) + '"';
    const char* end = text.data() + text.size();
    T parsed{};
    const auto result = std::from_chars(text.data(), end, parsed);
    if (result.ec == std::errc::result_out_of_range && result.ptr == end) {
        throw std::invalid_argument(shown + ": too large or too small to be held");
    }
    if (result.ec != std::errc{} || result.ptr != end) {
        const std::string_view number = std::integral<T> ? "a whole number" : "a number";
        throw std::invalid_argument(shown + ": " + refusal_of_text(number, special));
    }
    value = parsed;
}

void check(double value, const std::string& value_text, const ParameterRange& range, std::string_view what,
           std::span<const ParameterWord> special) {
    if (range.contains(value)) return;
    const std::string others = special.empty() ? "" : joined(special, ", ") + " or ";
    throw std::invalid_argument(std::string(what) + " = " + value_text + ": must be " + others + "in " +
                                to_text(range));
}

}  // namespace

std::string to_text(const ParameterRange& range) {
    return (range.min_end == RangeEnd::closed ? "[" : "(") + shortest_text(range.min) + ", " +
           shortest_text(range.max) + (range.max_end == RangeEnd::closed ? "]" : ")");
}

std::string range_text(const ParameterRange& range, std::span<const ParameterWord> special) {
    return special.empty() ? to_text(range) : joined(special, ", ") + " or " + to_text(range);
}

std::string range_text(std::span<const ParameterWord> words) { return '{' + joined(words, ", ") + '}'; }

std::string number_text(float value) { return shortest_text(value); }
std::string number_text(double value) { return shortest_text(value); }
std::string number_text(int value) { return shortest_text(value); }

void parse_number(std::string_view text, std::string_view what, float& value, std::span<const ParameterWord> special) {
    parse_whole_text(text, what, value, special);
}
void parse_number(std::string_view text, std::string_view what, double& value, std::span<const ParameterWord> special) {
    parse_whole_text(text, what, value, special);
}
void parse_number(std::string_view text, std::string_view what, int& value, std::span<const ParameterWord> special) {
    parse_whole_text(text, what, value, special);
}

void check_range(float value, const ParameterRange& range, std::string_view what,
                 std::span<const ParameterWord> special) {
    check(static_cast<double>(value), number_text(value), range, what, special);
}
void check_range(double value, const ParameterRange& range, std::string_view what,
                 std::span<const ParameterWord> special) {
    check(value, number_text(value), range, what, special);
}
void check_range(int value, const ParameterRange& range, std::string_view what,
                 std::span<const ParameterWord> special) {
    check(static_cast<double>(value), number_text(value), range, what, special);
}

int parse_word(std::string_view text, std::string_view what, std::span<const ParameterWord> words) {
    for (const ParameterWord& choice : words) {
        if (name_key(text) == name_key(choice.word)) return choice.value;
    }
    throw std::invalid_argument(std::string(what) + " = \"" + std::string(text) + "\": must be in " +
                                range_text(words));
}

void check_word(int value, std::span<const ParameterWord> words, std::string_view what) {
    if (std::ranges::find(words, value, &ParameterWord::value) != words.end()) return;
    throw std::invalid_argument(std::string(what) + " = " + number_text(value) + ": must be in " + range_text(words));
}

}  // namespace emulsion
