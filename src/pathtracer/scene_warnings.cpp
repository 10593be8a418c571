#include "pathtracer/scene_warnings.h"

#include <fmt/format.h>

namespace emulsion {

namespace {

/// The text without numbers, what is in quotes, and all from the first bracket on.
std::string kind_of(const std::string& what) {
    std::string kind;
    bool quoted = false;
    for (const char c : what) {
        if (c == '(' && !quoted) break;
        if (c == '"') quoted = !quoted;
        if (!quoted && !(c >= '0' && c <= '9')) kind += c;
    }
    return kind;
}

}  // namespace

void SceneWarnings::add(const SourcePlace& place, const std::string& what) {
    Kind& kind = kinds_[kind_of(what)];
    if (++kind.count > kShown) return;
    kind.last_shown = shown_.size();
    shown_.push_back(fmt::format("{}: {}", to_text(place), what));
}

std::vector<std::string> SceneWarnings::list() const {
    std::vector<std::string> warnings = shown_;
    for (const auto& [text, kind] : kinds_) {
        if (kind.count > kShown)
            warnings[kind.last_shown] += fmt::format(" (and {} more like this)", kind.count - kShown);
    }
    return warnings;
}

}  // namespace emulsion
