#include "pathtracer/scene_lexer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace emulsion {

namespace {

constexpr std::array<std::pair<char, char>, 8> kEscapes = {
    {{'b', '\b'}, {'f', '\f'}, {'n', '\n'}, {'r', '\r'}, {'t', '\t'}, {'\\', '\\'}, {'\'', '\''}, {'"', '"'}}};

std::optional<char> unescaped(char letter) noexcept {
    for (const auto& [escape, value] : kEscapes) {
        if (escape == letter) return value;
    }
    return std::nullopt;
}

bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool ends_word(char c) noexcept { return is_blank(c) || c == '"' || c == '[' || c == ']' || c == '#'; }

}  // namespace

const Token& Lexer::peek() {
    if (!ahead_) ahead_ = scan();
    return *ahead_;
}

Token Lexer::next() {
    Token token = peek();
    ahead_.reset();
    return token;
}

void Lexer::skip_blanks_and_comments() noexcept {
    const std::string_view text = source_->text();
    bool comment = false;
    for (; offset_ < text.size(); ++offset_) {
        const char c = text[offset_];
        if (c == '#') comment = true;
        if (c == '\n' || c == '\r') comment = false;
        if (!comment && !is_blank(c)) return;
    }
}

Token Lexer::scan() {
    skip_blanks_and_comments();
    const std::string_view text = source_->text();
    const SourcePlace place{source_, offset_};
    if (offset_ == text.size()) return {TokenKind::end, {}, place};

    const char first = text[offset_];
    if (first == '"') return scan_string();
    if (first == '[' || first == ']') {
        ++offset_;
        return {first == '[' ? TokenKind::open_bracket : TokenKind::close_bracket, text.substr(place.offset, 1), place};
    }
    while (offset_ < text.size() && !ends_word(text[offset_])) ++offset_;
    return {TokenKind::word, text.substr(place.offset, offset_ - place.offset), place};
}

Token Lexer::scan_string() {
    const std::string_view text = source_->text();
    const SourcePlace place{source_, offset_};
    for (std::size_t i = offset_ + 1; i < text.size() && text[i] != '\n' && text[i] != '\r'; ++i) {
        if (text[i] == '"') {
            offset_ = i + 1;
            return {TokenKind::string, text.substr(place.offset + 1, i - place.offset - 1), place};
        }
        if (text[i] != '\\' || i + 1 == text.size()) continue;
        const char letter = text[++i];
        if (!unescaped(letter)) {
            throw SceneError({source_, i - 1}, "the escape " + quote(text.substr(i - 1, 2)) + " in a string",
                             R"(one of \b \f \n \r \t \\ \' \")");
        }
    }
    throw SceneError(place, "a string without its closing quote", "a quote (\") before the end of the line");
}

std::string describe(const Token& token) {
    switch (token.kind) {
        case TokenKind::end:
            return "the end of the file";
        case TokenKind::string:
            return "the string " + quote(token.text);
        default:
            return quote(token.text);
    }
}

std::string string_value(const Token& token) {
    std::string value;
    value.reserve(token.text.size());
    for (std::size_t i = 0; i < token.text.size(); ++i) {
        const bool escape = token.text[i] == '\\' && i + 1 < token.text.size();
        value += escape ? unescaped(token.text[++i]).value_or('\\') : token.text[i];
    }
    return value;
}

double number_value(const Token& token, std::string_view expected) {
    const std::string_view text = token.text;
    double value = 0.0;
    if (token.kind == TokenKind::word) {
        const char* const begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        const bool whole_token = error != std::errc::invalid_argument && stop == end;
        if (whole_token && error == std::errc{} && std::isfinite(value)) return value;
        if (whole_token) throw SceneError(token.place, describe(token), "a finite number that double precision holds");
    }
    throw SceneError(token.place, describe(token), std::string(expected));
}

}  // namespace emulsion
