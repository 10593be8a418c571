#pragma once
// Scene text to tokens: words (directives, numbers, true and false), strings in double quotes, brackets. Blanks, line
// ends and comments (from # to the end of the line) only separate tokens.

#include <optional>
#include <string>
#include <string_view>

#include "pathtracer/scene_source.h"

namespace emulsion {

enum class TokenKind { word, string, open_bracket, close_bracket, end };

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text;  ///< as in the source; of a string, what is between the quotes
    SourcePlace place;
};

class Lexer {
  public:
    /// Starts at a byte offset that is not inside a token. The source must outlive the lexer and its tokens.
    explicit Lexer(const SourceText& source, std::size_t offset = 0) noexcept : source_(&source), offset_(offset) {}

    /// Both give a token of kind `end` at the end of the text, again and again.
    /// \throws SceneError for a string that its line doesn't close, or an unknown escape in one.
    [[nodiscard]] const Token& peek();
    Token next();

  private:
    [[nodiscard]] Token scan();
    void skip_blanks_and_comments() noexcept;
    [[nodiscard]] Token scan_string();

    const SourceText* source_;
    std::size_t offset_;
    std::optional<Token> ahead_;
};

/// What a token is called in messages.
[[nodiscard]] std::string describe(const Token& token);

/// The value of a string token: \b \f \n \r \t \\ \' \" stand for the characters they do in C.
[[nodiscard]] std::string string_value(const Token& token);

/// The value of a number token.
/// \throws SceneError if it is none, or not finite, or beyond double precision; `expected` says what should be there.
[[nodiscard]] double number_value(const Token& token, std::string_view expected = "a number");

}  // namespace emulsion
