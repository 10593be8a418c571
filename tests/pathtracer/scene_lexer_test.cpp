#include "pathtracer/scene_lexer.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> texts_of(std::string_view text) {
    const SourceText source{"t.pbrt", text};
    Lexer lexer(source);
    std::vector<std::string> texts;
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
        texts.push_back(token.kind == TokenKind::string ? "'" + string_value(token) + "'" : std::string(token.text));
    }
    return texts;
}

TEST(SceneLexer, SplitsWordsStringsAndBrackets) {
    EXPECT_THAT(texts_of("Shape\"sphere\"[1 2]3\t\r\n-.5e-3"),
                ElementsAre("Shape", "'sphere'", "[", "1", "2", "]", "3", "-.5e-3"));
    EXPECT_THAT(texts_of(""), ElementsAre());
    EXPECT_THAT(texts_of(" \n "), ElementsAre());
}

TEST(SceneLexer, CommentsRunToTheEndOfTheLine) {
    EXPECT_THAT(texts_of("# a [ \" b\n1 2#3\n4 # 5\r6 \"# no comment\" #"),
                ElementsAre("1", "2", "4", "6", "'# no comment'"));
}

TEST(SceneLexer, UndoesEscapes) {
    EXPECT_THAT(texts_of(R"("a\"b\\c\n\t\b\f\r\'")"), ElementsAre("'a\"b\\c\n\t\b\f\r''"));
}

TEST(SceneLexer, CountsLinesOfEverySystem) {
    const std::string text = "a\nb\r\nc\rd";
    const SourceText source{"t.pbrt", text};
    EXPECT_EQ(line_and_column({&source, 0}), (LineColumn{1, 1}));
    EXPECT_EQ(line_and_column({&source, text.find('b')}), (LineColumn{2, 1}));
    EXPECT_EQ(line_and_column({&source, text.find('c')}), (LineColumn{3, 1}));
    EXPECT_EQ(line_and_column({&source, text.find('d')}), (LineColumn{4, 1}));
    EXPECT_EQ(line_and_column({&source, text.size()}), (LineColumn{4, 2}));
}

TEST(SceneLexer, QuotesBinaryDataInOneLine) {
    EXPECT_EQ(quote(std::string("\0\n\xff\x7f ok", 7)), R"("\x00\x0a\xff\x7f ok")");
    EXPECT_EQ(quote(std::string(100, 'x')), "\"" + std::string(60, 'x') + "...\"");
}

double number_of(std::string_view text) {
    const SourceText source{"t.pbrt", text};
    Lexer lexer(source);
    return number_value(lexer.next());
}

TEST(SceneLexer, ReadsNumbers) {
    EXPECT_EQ(number_of("1"), 1.0);
    EXPECT_EQ(number_of("-0.25"), -0.25);
    EXPECT_EQ(number_of("+7"), 7.0);
    EXPECT_EQ(number_of(".5"), 0.5);
    EXPECT_EQ(number_of("5."), 5.0);
    EXPECT_EQ(number_of("1e3"), 1000.0);
    EXPECT_EQ(number_of("-2.5E-2"), -0.025);
    EXPECT_EQ(number_of("1e-300"), 1e-300);
}

TEST(SceneLexer, RefusesWhatIsNoFiniteNumber) {
    for (const char* const text : {"", "x", "1x", "1e", "--1", "+-1", "0x10", "1,5", "[", "\"1\"", "+"}) {
        EXPECT_THROW(static_cast<void>(number_of(text)), SceneError) << text;
    }
    for (const std::string text : {"nan", "inf", "-inf", "infinity", "1e400", "-1e400", "1e-400"}) {
        EXPECT_EQ(testing::error_of("Translate 0 " + text),
                  "t.pbrt:1:13: found \"" + text + "\", expected a finite number that double precision holds");
    }
}

TEST(SceneLexer, ErrorsNameTheTokenAtFault) {
    EXPECT_EQ(testing::error_of("Camera \"persp"),
              "t.pbrt:1:8: found a string without its closing quote, expected a quote (\") before the end of the line");
    EXPECT_EQ(testing::error_of("Camera\n  \"persp\nective\""),
              "t.pbrt:2:3: found a string without its closing quote, expected a quote (\") before the end of the line");
    EXPECT_EQ(testing::error_of(R"(Camera "a\qb")"),
              R"(t.pbrt:1:10: found the escape "\q" in a string, expected one of \b \f \n \r \t \\ \' \")");
    EXPECT_EQ(testing::error_of("Camera \"a\\"),
              "t.pbrt:1:8: found a string without its closing quote, expected a quote (\") before the end of the line");
}

TEST(SceneError, KnowsItsPlace) {
    try {
        static_cast<void>(parse_scene("\n  Foo", "folder/x.pbrt"));
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_EQ(error.file(), "folder/x.pbrt");
        EXPECT_EQ(error.line(), 2);
        EXPECT_EQ(error.column(), 3);
    }
}

}  // namespace
}  // namespace emulsion
