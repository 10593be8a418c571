#include "cli/json_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

namespace emulsion::cli {

namespace {

/// Bytes of the character that the text begins with; 0 if that is no UTF-8 (Unicode, table 3-7).
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) return 1;
    if (lead < 0xC2 || lead > 0xF4) return 0;
    const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (text.size() < length) return 0;
    const std::uint8_t least = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
    const std::uint8_t greatest = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
    if (byte(1) < least || byte(1) > greatest) return 0;
    const auto continues = [](char c) { return (static_cast<std::uint8_t>(c) & 0xC0) == 0x80; };
    return std::all_of(text.begin() + 2, text.begin() + static_cast<std::ptrdiff_t>(length), continues) ? length : 0;
}

}  // namespace

std::string json_text(std::string_view words) {
    std::string text = "\"";
    while (!words.empty()) {
        const std::size_t length = utf8_length(words);
        const char first = words.front();
        if (length == 0) {
            text += "\\ufffd";
        } else if (static_cast<std::uint8_t>(first) < 0x20) {
            text += fmt::format("\\u{:04x}", static_cast<unsigned>(first));
        } else {
            if (first == '"' || first == '\\') text += '\\';
            text += words.substr(0, length);
        }
        words.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return text + '"';
}

std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null"; }

}  // namespace emulsion::cli
