#include "pathtracer/scene_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace emulsion {

namespace {

/// What kind of token the values are.
enum class TokenType { number, whole_number, truth, string, number_or_string };

struct TypeName {
    std::string_view name;
    DeclaredType type;
    TokenType token;
    Support support = Support::here;
};

constexpr auto kTypeNames = std::to_array<TypeName>({
    {"integer", DeclaredType::integer, TokenType::whole_number},
    {"float", DeclaredType::real, TokenType::number},
    {"bool", DeclaredType::boolean, TokenType::truth},
    {"string", DeclaredType::string, TokenType::string},
    {"point2", DeclaredType::point2, TokenType::number},
    {"vector2", DeclaredType::vector2, TokenType::number},
    {"point3", DeclaredType::point3, TokenType::number},
    {"point", DeclaredType::point3, TokenType::number},
    {"vector3", DeclaredType::vector3, TokenType::number},
    {"vector", DeclaredType::vector3, TokenType::number},
    {"normal", DeclaredType::normal, TokenType::number},
    {"normal3", DeclaredType::normal, TokenType::number},
    {"rgb", DeclaredType::rgb, TokenType::number},
    {"blackbody", DeclaredType::blackbody, TokenType::number},
    {"spectrum", DeclaredType::spectrum, TokenType::number_or_string},
    {"texture", DeclaredType::texture, TokenType::string},
});

bool is_truth(const Token& token, std::string_view word) {
    // pbrt-v4 itself takes the bare words only; older files have them in quotes.
    return (token.kind == TokenKind::word || token.kind == TokenKind::string) && token.text == word;
}

constexpr std::string_view expected_token(TokenType type, bool in_brackets) {
    switch (type) {
        case TokenType::truth:
            return in_brackets ? R"(true, false or "]")" : "true or false";
        case TokenType::string:
            return in_brackets ? R"(a string or "]")" : "a string";
        case TokenType::number_or_string:
            return in_brackets ? R"(a number, a string or "]")" : "a number or a string";
        default:
            return in_brackets ? R"(a number or "]")" : "a number";
    }
}

/// Reads a token as one value.
void add_value(SceneParameter& parameter, const Token& token, TokenType type, bool in_brackets) {
    const std::string_view expected = expected_token(type, in_brackets);
    if (type == TokenType::truth) {
        if (!is_truth(token, "true") && !is_truth(token, "false")) {
            throw SceneError(token.place, describe(token), std::string(expected));
        }
        parameter.numbers.push_back(token.text == "true" ? 1.0 : 0.0);
        return;
    }
    const bool wants_string =
        type == TokenType::string ||
        (type == TokenType::number_or_string && token.kind == TokenKind::string && parameter.numbers.empty());
    if (wants_string) {
        if (token.kind != TokenKind::string) throw SceneError(token.place, describe(token), std::string(expected));
        parameter.strings.push_back(string_value(token));
        return;
    }
    if (!parameter.strings.empty()) {
        throw SceneError(token.place, describe(token), R"(a string after a string, or "]")");
    }
    const double number = number_value(token, expected);
    constexpr double kLargest = std::numeric_limits<int>::max(), kSmallest = std::numeric_limits<int>::min();
    if (type == TokenType::whole_number && (number != std::trunc(number) || number > kLargest || number < kSmallest)) {
        throw SceneError(token.place, describe(token), "a whole number of at most 32 bits");
    }
    parameter.numbers.push_back(number);
}

void read_values(Lexer& lexer, SceneParameter& parameter, TokenType type) {
    Token token = lexer.next();
    parameter.first_value = token.place;
    if (token.kind != TokenKind::open_bracket) return add_value(parameter, token, type, false);

    const SourcePlace opened = token.place;
    parameter.first_value = lexer.peek().place;
    while ((token = lexer.next()).kind != TokenKind::close_bracket) {
        if (token.kind == TokenKind::end) {
            throw SceneError(token.place, describe(token), R"(a "]" for the "[" at )" + to_text(opened));
        }
        add_value(parameter, token, type, true);
    }
    if (parameter.numbers.empty() && parameter.strings.empty()) {
        throw SceneError(token.place, R"("]" right after "[")", "at least one value");
    }
}

/// Splits "type name".
SceneParameter declare(const Token& token, TokenType& token_type) {
    const std::string text = string_value(token);
    constexpr std::string_view kBlanks = " \t";
    const auto type_begin = text.find_first_not_of(kBlanks);
    const auto type_end = text.find_first_of(kBlanks, type_begin);
    const auto name_begin = text.find_first_not_of(kBlanks, type_end);
    const auto name_end = text.find_first_of(kBlanks, name_begin);
    const bool two_words = name_begin != std::string::npos && type_begin != std::string::npos &&
                           text.find_first_not_of(kBlanks, name_end) == std::string::npos;
    if (!two_words) throw SceneError(token.place, describe(token), R"(a parameter's "type name")");

    const std::string_view type_name = std::string_view(text).substr(type_begin, type_end - type_begin);
    const auto& type = supported_row<TypeName>(token.place, {"parameter type"}, type_name, kTypeNames);
    token_type = type.token;
    SceneParameter parameter;
    parameter.place = token.place;
    parameter.type = type.type;
    parameter.name = text.substr(name_begin, name_end - name_begin);
    return parameter;
}

}  // namespace

std::vector<SceneParameter> read_parameters(Lexer& lexer) {
    std::vector<SceneParameter> parameters;
    std::map<std::string, SourcePlace> seen;
    while (lexer.peek().kind == TokenKind::string) {
        TokenType type{};
        SceneParameter parameter = declare(lexer.next(), type);
        const auto [earlier, first] = seen.try_emplace(parameter.name, parameter.place);
        if (!first) {
            throw SceneError(parameter.place, "a second parameter " + quote(parameter.name),
                             "each only once (the first is at " + to_text(earlier->second) + ")");
        }
        read_values(lexer, parameter, type);
        parameters.push_back(std::move(parameter));
    }
    return parameters;
}

ColorSpace color_space_of(const SourcePlace& place, std::string_view name) {
    struct SpaceName {
        std::string_view name;
        ColorSpace space;
    };
    constexpr auto kSpaces = std::to_array<SpaceName>({{"srgb", ColorSpace::srgb},
                                                       {"rec2020", ColorSpace::rec2020},
                                                       {"dci-p3", ColorSpace::dci_p3},
                                                       {"aces2065-1", ColorSpace::aces2065_1}});
    std::string key(name);
    std::transform(key.begin(), key.end(), key.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
    return supported_row<SpaceName>(place, {"colour space"}, key, kSpaces).space;
}

namespace {

bool has_parameter(const Implementation& implementation, std::string_view name) noexcept {
    return std::ranges::any_of(implementation.parameters, [name](const auto& row) { return row.name == name; });
}

}  // namespace

bool knows_parameter(const ImplementationTable& table, std::string_view name) noexcept {
    return std::ranges::any_of(table.implementations, [name](const auto& row) { return has_parameter(row, name); });
}

void inherit_parameters(const ImplementationTable& table, ParameterList& list, const InheritedParameters& inherited) {
    const auto owner =
        std::ranges::find_if(table.implementations, [&](const auto& row) { return row.name == list.owner; });
    if (owner == table.implementations.end()) return;  // an error that is found later
    for (const auto& [name, parameter] : inherited) {
        if (find_parameter(list, name) != nullptr || !has_parameter(*owner, name)) continue;
        list.parameters.push_back(*parameter);
    }
}

const SceneParameter* find_parameter(const ParameterList& list, std::string_view name) noexcept {
    for (const SceneParameter& parameter : list.parameters) {
        if (parameter.name == name) return &parameter;
    }
    return nullptr;
}

SourcePlace place_of_value(const SceneParameter& parameter, std::size_t index) {
    Lexer lexer(*parameter.first_value.source, parameter.first_value.offset);
    for (std::size_t i = 0; i < index; ++i) lexer.next();
    return lexer.peek().place;
}

double real_or(const ParameterList& list, std::string_view name, double otherwise) noexcept {
    const SceneParameter* const parameter = find_parameter(list, name);
    return parameter == nullptr ? otherwise : parameter->numbers.front();
}

int integer_or(const ParameterList& list, std::string_view name, int otherwise) noexcept {
    return static_cast<int>(real_or(list, name, otherwise));
}

std::string string_or(const ParameterList& list, std::string_view name, std::string_view otherwise) {
    const SceneParameter* const parameter = find_parameter(list, name);
    return parameter == nullptr ? std::string(otherwise) : parameter->strings.front();
}

Imath::V3d point_or(const ParameterList& list, std::string_view name, const Imath::V3d& otherwise) noexcept {
    const SceneParameter* const parameter = find_parameter(list, name);
    if (parameter == nullptr) return otherwise;
    return {parameter->numbers[0], parameter->numbers[1], parameter->numbers[2]};
}

Flag flag_or(const ParameterList& list, std::string_view name, Flag otherwise) noexcept {
    return real_or(list, name, otherwise == Flag::on ? 1.0 : 0.0) != 0.0 ? Flag::on : Flag::off;
}

}  // namespace emulsion
