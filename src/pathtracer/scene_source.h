#pragma once
// Places in scene text, and the error that names one. A place is a file and a byte offset; line and column are looked
// up only when somebody asks, so that tokens stay small. Lines and columns count from 1, columns in bytes.

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace emulsion {

/// The text of one file; outlived by nothing that points into it. One scene may consist of several.
class SourceText {
  public:
    /// `name` is shown in messages. The text is not copied.
    SourceText(std::filesystem::path name, std::string_view text);

    [[nodiscard]] const std::filesystem::path& name() const noexcept { return name_; }
    [[nodiscard]] std::string_view text() const noexcept { return text_; }
    /// Byte offsets of the starts of lines, the first of them 0. Lines end with \n, \r\n or \r.
    [[nodiscard]] const std::vector<std::size_t>& lines() const noexcept { return lines_; }

  private:
    std::filesystem::path name_;
    std::string_view text_;
    std::vector<std::size_t> lines_;
};

struct SourcePlace {
    const SourceText* source = nullptr;
    std::size_t offset = 0;  ///< bytes from the start of the text; at most its size
};

struct LineColumn {
    int line = 1, column = 1;
    bool operator==(const LineColumn&) const = default;
};

[[nodiscard]] LineColumn line_and_column(const SourcePlace& place) noexcept;

/// "file:line:column".
[[nodiscard]] std::string to_text(const SourcePlace& place);

/// A scene that can't be read as it is. what() is "file:line:column: found X, expected Y", in one line.
class SceneError : public std::runtime_error {
  public:
    SceneError(const SourcePlace& place, const std::string& found, const std::string& expected);

    [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
    [[nodiscard]] int line() const noexcept { return where_.line; }
    [[nodiscard]] int column() const noexcept { return where_.column; }

  private:
    std::filesystem::path file_;
    LineColumn where_;
};

/// `text` in double quotes, as it can be shown in one line: unprintable bytes as \xNN, cut after 60 bytes.
[[nodiscard]] std::string quote(std::string_view text);

}  // namespace emulsion
