#pragma once
// Named values: plain types with a name, one line of help and a table of parameters (core/parameters.h), held in a
// std::variant. To add one, write its type and add it to the variant; everything here iterates the variant.
//
// Text form: name, or name:parameter=value,parameter=value. Parameters that are left out have their default. to_text
// prints all of them, in the order of the table, so that a stored text means the same after a default has changed.

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/name_key.h"
#include "core/parameters.h"
#include "core/table_point.h"
#include "core/visit.h"

namespace emulsion {

template <class T>
concept NamedValue = std::default_initializable<T> && std::equality_comparable<T> && requires {
    { T::kName } -> std::convertible_to<std::string_view>;
    { T::kHelp } -> std::convertible_to<std::string_view>;
};

template <class T>
struct IsNamedVariant : std::false_type {};
template <NamedValue... Ts>
struct IsNamedVariant<std::variant<Ts...>> : std::true_type {};

/// A std::variant whose alternatives are all named values.
template <class T>
concept NamedVariant = IsNamedVariant<T>::value;

/// What --help says about one alternative.
struct NamedValueDescription {
    std::string_view name;
    std::string_view help;
    std::vector<ParameterDescription> parameters;
    bool operator==(const NamedValueDescription&) const = default;
};

/// The table of a type; empty if the type has no data members, or points instead.
template <NamedValue T>
[[nodiscard]] constexpr std::span<const Parameter<T>> parameters_of() noexcept {
    if constexpr (requires { T::kParameters; }) {
        return T::kParameters;
    } else {
        static_assert(std::is_empty_v<T> || NamedTable<T>, "a named value with data members needs a kParameters table");
        return {};
    }
}

/// Calls visitor(T{}) for every alternative of the variant, in its order.
template <NamedVariant Variant, class Visitor>
constexpr void for_each_alternative(Visitor&& visitor) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (visitor(std::variant_alternative_t<I, Variant>{}), ...); }
    (std::make_index_sequence<std::variant_size_v<Variant>>{});
}

/// How messages name a parameter: "tonemap reinhard-global: key"; an empty kind is left out.
[[nodiscard]] std::string parameter_label(std::string_view kind, std::string_view name, std::string_view parameter);

/// The same of the whole value: "transfer table".
[[nodiscard]] std::string named_label(std::string_view kind, std::string_view name);

/// The word of `special` that a parameter's value stands for; empty if it is a number. Out of line for the reason that
/// parameter_text() gives.
template <NamedValue T>
[[nodiscard, gnu::noinline]] std::string_view special_word(const T& value, const Parameter<T>& parameter) {
    const auto word_of = [&]<class M>(M T::*member) -> std::string_view {
        for (const ParameterWord& choice : parameter.special) {
            if (value.*member == static_cast<M>(choice.value)) return choice.word;
        }
        return {};
    };
    return std::visit(word_of, parameter.member);
}

/// \throws std::invalid_argument naming type, parameter, value and range, for the first parameter out of its range.
/// `kind` is the role of the value, as in parse_named.
template <NamedValue T>
void validate_named(const T& value, std::string_view kind = "") {
    for (const Parameter<T>& parameter : parameters_of<T>()) {
        const std::string what = parameter_label(kind, T::kName, parameter.name);
        if (special_word(value, parameter).empty()) {
            const auto check = [&](auto member) {
                check_range(value.*member, parameter.range, what, parameter.special);
            };
            std::visit(check, parameter.member);
        }
        if (parameter.words.empty()) continue;
        std::visit([&](auto member) { check_word(static_cast<int>(value.*member), parameter.words, what); },
                   parameter.member);
    }
    if constexpr (NamedTable<T>) check_points(value, named_label(kind, T::kName));
}
template <NamedVariant Variant>
void validate_named(const Variant& variant, std::string_view kind = "") {
    std::visit([&](const auto& value) { validate_named(value, kind); }, variant);
}

/// A parameter as text forms have it. Out of line for GCC 12, which otherwise sees members of all types read from a
/// value whose type it knows, and warns of those that the type doesn't have.
template <NamedValue T>
[[nodiscard, gnu::noinline]] std::string parameter_text(const T& value, const Parameter<T>& parameter) {
    const auto text_of = [&](auto member) {
        for (const ParameterWord& choice : parameter.words) {
            if (static_cast<int>(value.*member) == choice.value) return std::string(choice.word);
        }
        const std::string_view special = special_word(value, parameter);
        return special.empty() ? number_text(value.*member) : std::string(special);
    };
    return std::visit(text_of, parameter.member);
}

/// The text form of a value, with all its parameters; parse_named reads it back as the same value.
template <NamedValue T>
[[nodiscard]] std::string to_text(const T& value) {
    std::string text(T::kName);
    char separator = ':';
    for (const Parameter<T>& parameter : parameters_of<T>()) {
        text += std::exchange(separator, ',');
        text += parameter.name;
        text += '=';
        text += parameter_text(value, parameter);
    }
    if constexpr (NamedTable<T>) {
        for (const TablePoint& point : value.points) {
            text += std::exchange(separator, ',');
            text += number_text(point.x) + '=' + number_text(point.y);
        }
    }
    return text;
}
template <NamedVariant Variant>
[[nodiscard]] std::string to_text(const Variant& variant) {
    return std::visit([](const auto& value) { return to_text(value); }, variant);
}

/// The names of all alternatives, in the variant's order.
template <NamedVariant Variant>
[[nodiscard]] std::vector<std::string_view> names_of() {
    std::vector<std::string_view> names;
    for_each_alternative<Variant>([&]<class T>(const T&) { names.push_back(T::kName); });
    return names;
}

/// Every alternative with its parameters, in the variant's order.
template <NamedVariant Variant>
[[nodiscard]] std::vector<NamedValueDescription> describe_named() {
    std::vector<NamedValueDescription> all;
    for_each_alternative<Variant>([&]<class T>(const T&) {
        static const T defaults{};  // GCC 12 takes a temporary for uninitialised: no type has members of all types
        NamedValueDescription description{T::kName, T::kHelp, {}};
        for (const Parameter<T>& parameter : parameters_of<T>()) {
            description.parameters.push_back(
                {parameter.name, parameter_text(defaults, parameter),
                 parameter.words.empty() ? range_text(parameter.range, parameter.special) : range_text(parameter.words),
                 parameter.unit, parameter.help});
        }
        all.push_back(std::move(description));
    });
    return all;
}

/// A text form taken apart: "a:b=1,c=2" is {"a", {{"b", "1"}, {"c", "2"}}}.
struct NamedText {
    std::string_view name;
    std::vector<std::pair<std::string_view, std::string_view>> assignments;
};

/// `kind` is the role of the value in messages: "tonemap".
/// \throws std::invalid_argument if an assignment lacks its '=' or its name, or if a name is given twice.
[[nodiscard]] NamedText split_named_text(std::string_view text, std::string_view kind);

/// \throws std::invalid_argument that lists `known`, the names most like `name` first. `what` says what was looked for:
/// "tonemap".
[[noreturn]] void throw_unknown_name(std::string_view what, std::string_view name, std::vector<std::string_view> known);

/// The reverse of parameter_text(); `what` names the parameter in messages. Out of line for the same reason.
/// \throws std::invalid_argument as parse_number() and check_range(): a number that stands for a word is no number.
template <NamedValue T>
[[gnu::noinline]] void read_parameter(std::string_view text, std::string_view what, T& value,
                                      const Parameter<T>& parameter) {
    if (!parameter.words.empty()) {
        const int choice = parse_word(text, what, parameter.words);
        std::visit([&]<class M>(M T::*member) { value.*member = static_cast<M>(choice); }, parameter.member);
        return;
    }
    for (const ParameterWord& choice : parameter.special) {
        if (name_key(text) != name_key(choice.word)) continue;
        std::visit([&]<class M>(M T::*member) { value.*member = static_cast<M>(choice.value); }, parameter.member);
        return;
    }
    const auto read_number = [&](auto member) {
        parse_number(text, what, value.*member, parameter.special);
        check_range(value.*member, parameter.range, what, parameter.special);
    };
    std::visit(read_number, parameter.member);
}

/// Points as x=y; `label` names the value in messages. \throws std::invalid_argument as parse_number().
[[nodiscard]] std::vector<TablePoint> parse_points(const NamedText& text, std::string_view label);

/// Reads one alternative's parameters, or points.
template <NamedValue T>
[[nodiscard]] T parse_parameters(const NamedText& text, std::string_view kind) {
    T value;
    if constexpr (NamedTable<T>) {
        if (!text.assignments.empty()) value.points = parse_points(text, named_label(kind, T::kName));
        validate_named(value, kind);
        return value;
    }
    for (const auto& assignment : text.assignments) {
        std::vector<std::string_view> known;
        bool found = false;
        for (const Parameter<T>& parameter : parameters_of<T>()) {
            known.push_back(parameter.name);
            if (name_key(parameter.name) != name_key(assignment.first)) continue;
            found = true;
            read_parameter(assignment.second, parameter_label(kind, T::kName, assignment.first), value, parameter);
        }
        if (!found)
            throw_unknown_name(parameter_label(kind, T::kName, "parameter"), assignment.first, std::move(known));
    }
    validate_named(value, kind);
    return value;
}

/// Reads a text form; names are spelt as core/name_key.h allows. `kind` is the role of the value, used in messages:
/// "tonemap". \throws std::invalid_argument for an unknown name or parameter (listing the right ones, nearest first), a
/// malformed number, a value out of its range (naming the range), or a parameter given twice.
/// \param others names besides, for the list
template <NamedVariant Variant>
[[nodiscard]] Variant parse_named(std::string_view text, std::string_view kind,
                                  const std::vector<std::string_view>& others = {}) {
    const NamedText parts = split_named_text(text, kind);
    Variant result;
    bool found = false;
    for_each_alternative<Variant>([&]<class T>(const T&) {
        if (name_key(T::kName) != name_key(parts.name)) return;
        result = parse_parameters<T>(parts, kind);
        found = true;
    });
    if (found) return result;
    std::vector<std::string_view> known = names_of<Variant>();
    known.insert(known.end(), others.begin(), others.end());
    throw_unknown_name(kind, parts.name, std::move(known));
}

/// The same, or none for the word `none`.
template <NamedVariant Variant>
[[nodiscard]] std::optional<Variant> parse_named_or(std::string_view none, std::string_view text,
                                                    std::string_view kind) {
    if (name_key(text) == name_key(none)) return std::nullopt;
    return parse_named<Variant>(text, kind, {none});
}

}  // namespace emulsion
