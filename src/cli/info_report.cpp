#include "cli/info_report.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/json_text.h"

namespace emulsion::cli {

void InfoReport::line(std::string_view label, std::string_view text) {
    if (text.empty()) return;
    std::string plain(text);
    // What files say of themselves goes to a terminal.
    for (char& c : plain) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    }
    lines_.emplace_back(label, std::move(plain));
}

void InfoReport::member(std::string_view key, std::string json) { members_.emplace_back(key, std::move(json)); }

void InfoReport::member_text(std::string_view key, std::string_view text) { member(key, json_text(text)); }

std::string InfoReport::text() const {
    std::size_t width = 0;
    for (const auto& [label, text] : lines_) width = std::max(width, label.size());
    std::string all;
    for (const auto& [label, text] : lines_) all += fmt::format("{:<{}}  {}\n", label, width, text);
    return all;
}

std::string InfoReport::json() const {
    std::string all = "{";
    for (const auto& [key, json] : members_) {
        all += fmt::format("{}\n  {}: {}", all.size() > 1 ? "," : "", json_text(key), json);
    }
    return all + "\n}\n";
}

std::string json_list(const std::vector<std::string>& values) { return fmt::format("[{}]", fmt::join(values, ", ")); }

std::string json_object(const std::vector<std::pair<std::string_view, std::string>>& members) {
    std::vector<std::string> texts;
    texts.reserve(members.size());
    for (const auto& [key, json] : members) texts.push_back(json_text(key) + ": " + json);
    return fmt::format("{{{}}}", fmt::join(texts, ", "));
}

}  // namespace emulsion::cli
