#include "pathtracer/scene_source.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace emulsion {

SourceText::SourceText(std::filesystem::path name, std::string_view text)
    : name_(std::move(name)), text_(text), lines_{0} {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool ends_line = text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
        if (ends_line) lines_.push_back(i + 1);
    }
}

LineColumn line_and_column(const SourcePlace& place) noexcept {
    const std::vector<std::size_t>& lines = place.source->lines();
    const auto next = std::upper_bound(lines.begin(), lines.end(), place.offset);
    return {static_cast<int>(next - lines.begin()), static_cast<int>(place.offset - *std::prev(next)) + 1};
}

std::string to_text(const SourcePlace& place) {
    const LineColumn where = line_and_column(place);
    return fmt::format("{}:{}:{}", place.source->name().string(), where.line, where.column);
}

SceneError::SceneError(const SourcePlace& place, const std::string& found, const std::string& expected)
    : std::runtime_error(fmt::format("{}: found {}, expected {}", to_text(place), found, expected)),
      file_(place.source->name()),
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
