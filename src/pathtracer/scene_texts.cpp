#include "pathtracer/scene_texts.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace emulsion {

namespace {

/// One name for all names of a file: without links, "." and "..".
std::string one_name_of(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path found = std::filesystem::weakly_canonical(path, error);
    return (error ? path : found).string();
}

}  // namespace

SceneTexts::SceneTexts(const std::filesystem::path& name, std::string_view text) : main_(name, text) {
    const auto kept = kept_.emplace(one_name_of(name), KeptText{{}, nullptr, true}).first;
    open_.push_back({Lexer(main_), TextKind::main, &kept->first});
}

std::map<std::string, SceneTexts::KeptText>::iterator SceneTexts::kept_text(const Token& name, SceneFiles& files) {
    const std::string value = string_value(name);
    const auto [canonical, is_new] = canonical_name_.try_emplace(value);
    if (is_new) canonical->second = one_name_of(files.path_of(value));
    const auto [kept, is_unread] = kept_.try_emplace(canonical->second);
    if (is_unread) {
        kept->second.content = files.read(name.place, value);
        kept->second.source = std::make_unique<const SourceText>(files.path_of(value), kept->second.content);
    }
    return kept;
}

void SceneTexts::open(const Token& name, TextKind kind, SceneFiles& files) {
    const auto kept = kept_text(name, files);
    if (kept->second.is_open)
        throw SceneError(name.place, cycle_of(kept->first), "files that don't include themselves");
    ++includes_;
    bytes_ += kept->second.content.size();
    if (includes_ > kMostIncludes || bytes_ > kMostBytes) {
        throw SceneError(name.place, fmt::format("file number {}, after {} bytes of text", includes_, bytes_),
                         fmt::format("a scene of at most {} files and {} bytes", kMostIncludes, kMostBytes));
    }
    kept->second.is_open = true;
    open_.push_back({Lexer(*kept->second.source), kind, &kept->first});
}

std::string SceneTexts::cycle_of(const std::string& file) const {
    constexpr std::size_t kFew = 5;
    const auto shown = [](const std::string& name) { return quote(std::filesystem::path(name).filename().string()); };
    std::string through;
    std::size_t between = 0;
    for (auto text = open_.rbegin(); text != open_.rend() && *text->file != file; ++text, ++between) {
        if (between < kFew) through += (between == 0 ? "" : ", ") + shown(*text->file);
    }
    std::string what = fmt::format("the file {} inside itself", shown(file));
    if (between == 0) return what;
    return fmt::format("{} (through {}{})", what, through,
                       between > kFew ? fmt::format(" and {} more", between - kFew) : "");
}

TextKind SceneTexts::close() {
    const TextKind kind = open_.back().kind;
    if (kind == TextKind::main) return kind;
    kept_.at(*open_.back().file).is_open = false;
    open_.pop_back();
    return kind;
}

}  // namespace emulsion
