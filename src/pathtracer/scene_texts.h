#pragma once
// The texts that a scene is made of: its own, and those that Include and Import bring in. They are read one inside the
// other, by an explicit stack, so that deep nesting costs memory only. All are kept to the end, as places point into
// them; a text that is included again is not read again.

#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "pathtracer/scene_files.h"
#include "pathtracer/scene_lexer.h"
#include "pathtracer/scene_source.h"

namespace emulsion {

enum class TextKind { main, included, imported };

class SceneTexts {
  public:
    /// Opens the scene's own text; `name` stands for it in messages.
    SceneTexts(const std::filesystem::path& name, std::string_view text);

    /// Of the innermost open text. Stays where it is while others are opened and closed inside.
    [[nodiscard]] Lexer& lexer() noexcept { return open_.back().lexer; }

    /// Opens the file that `name`, a string token, names.
    /// \throws SceneError if it can't be read, if it is open already, or if the scene includes more than kMostIncludes
    /// files or kMostBytes of text: a few files that include each other twice could go on for ever.
    void open(const Token& name, TextKind kind, SceneFiles& files);

    /// Closes the innermost text, unless it is the main one, and says what it was.
    TextKind close();

    static constexpr std::size_t kMostIncludes = 1'000'000;
    static constexpr std::size_t kMostBytes = std::size_t{1} << 34u;

  private:
    struct OpenText {
        Lexer lexer;
        TextKind kind = TextKind::main;
        const std::string* file = nullptr;  // its one canonical name
    };
    struct KeptText {
        std::string content;
        std::unique_ptr<const SourceText> source;
        bool is_open = false;
    };

    /// The text of the file that `name` names, read if it is new.
    [[nodiscard]] std::map<std::string, KeptText>::iterator kept_text(const Token& name, SceneFiles& files);
    [[nodiscard]] std::string cycle_of(const std::string& file) const;

    SourceText main_;
    std::map<std::string, KeptText> kept_;               // by canonical name
    std::map<std::string, std::string> canonical_name_;  // by the name in the scene
    std::deque<OpenText> open_;
    std::size_t includes_ = 0, bytes_ = 0;
};

}  // namespace emulsion
