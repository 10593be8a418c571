#include "pathtracer/scene_source.h"

#include <fmt/format.h>

namespace emulsion {

LineColumn line_and_column(const SourcePlace& place) noexcept {
    const std::string_view text = place.source->text;
    LineColumn where;
    for (std::size_t i = 0; i < place.offset && i < text.size(); ++i) {
        const bool ends_line = text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
        if (ends_line) {
            ++where.line;
            where.column = 1;
        } else {
            ++where.column;
        }
    }
    return where;
}

std::string to_text(const SourcePlace& place) {
    const LineColumn where = line_and_column(place);
    return fmt::format("{}:{}:{}", place.source->name.string(), where.line, where.column);
}

SceneError::SceneError(const SourcePlace& place, const std::string& found, const std::string& expected)
    : std::runtime_error(fmt::format("{}: found {}, expected {}", to_text(place), found, expected)),
      file_(place.source->name),
      where_(line_and_column(place)) {}

std::string quote(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    std::string shown = "\"";
    for (const char c : text.substr(0, kLongest)) {
        const auto byte = static_cast<unsigned char>(c);
        const bool printable = byte >= 0x20 && byte < 0x7f;
        shown += printable ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
    }
    return shown + (text.size() > kLongest ? "...\"" : "\"");
}

}  // namespace emulsion
