#include "core/named_value.h"

#include <algorithm>
#include <stdexcept>

#include "core/nearest_name.h"

namespace emulsion {

namespace {

std::string with_kind(std::string_view kind, std::string_view rest) {
    return kind.empty() ? std::string(rest) : std::string(kind) + ' ' + std::string(rest);
}

std::pair<std::string_view, std::string_view> split_assignment(std::string_view text, const std::string& what) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0) {
        throw std::invalid_argument(what + ": found \"" + std::string(text) + "\", expected parameter=value");
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace

NamedText split_named_text(std::string_view text, std::string_view kind) {
    const std::size_t colon = text.find(':');
    NamedText parts{text.substr(0, colon), {}};
    if (colon == std::string_view::npos) return parts;

    const std::string what = with_kind(kind, parts.name);
    for (std::size_t begin = colon + 1; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto assignment = split_assignment(text.substr(begin, end - begin), what);
        for (const auto& earlier : parts.assignments) {
            if (name_key(earlier.first) != name_key(assignment.first)) continue;
            throw std::invalid_argument(parameter_label(kind, parts.name, assignment.first) + ": given twice");
        }
        parts.assignments.push_back(assignment);
        begin = end + 1;
    }
    return parts;
}

std::string parameter_label(std::string_view kind, std::string_view name, std::string_view parameter) {
    return with_kind(kind, name) + ": " + std::string(parameter);
}

std::string named_label(std::string_view kind, std::string_view name) { return with_kind(kind, name); }

std::vector<TablePoint> parse_points(const NamedText& text, std::string_view label) {
    std::vector<TablePoint> points;
    for (const auto& [x, y] : text.assignments) {
        const std::string what = std::string(label) + ": point " + std::to_string(points.size() + 1);
        TablePoint point;
        parse_number(x, what, point.x);
        parse_number(y, what, point.y);
        points.push_back(point);
    }
    return points;
}

void throw_unknown_name(std::string_view what, std::string_view name, std::vector<std::string_view> known) {
    std::stable_sort(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
        return name_distance(name, a) < name_distance(name, b);
    });
    std::string message = with_kind(what, '"' + std::string(name) + "\": unknown; ");
    if (known.empty()) message += "there are none";
    for (std::size_t i = 0; i < known.size(); ++i) {
        message += i == 0 ? "expected " : (i + 1 == known.size() ? " or " : ", ");
        message += known[i];
    }
    throw std::invalid_argument(message);
}

}  // namespace emulsion
