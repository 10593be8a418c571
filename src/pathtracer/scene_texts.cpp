#include "pathtracer/scene_texts.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace emulsion {

namespace {

/// One name for all names of a file: without links, "." and "..".
std::filesystem::path one_name_of(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::path found = std::filesystem::weakly_canonical(path, error);
    return error ? path : found;
}

}  // namespace

SceneTexts::SceneTexts(const std::filesystem::path& name, std::string_view text) : main_(name, text) {
    const std::filesystem::path file = one_name_of(name);
    open_.push_back({Lexer(main_), TextKind::main, file});
    open_files_.insert(file);
}

void SceneTexts::open(const Token& name, TextKind kind, SceneFiles& files) {
    const std::string value = string_value(name);
    const std::filesystem::path file = one_name_of(files.path_of(value));
    if (open_files_.contains(file)) {
        throw SceneError(name.place, cycle_of(file), "files that don't include themselves");
    }
    auto kept = kept_.find(file);
    if (kept == kept_.end()) {
        std::string content = files.read(name.place, value);
        kept = kept_.emplace(file, KeptText{std::move(content), nullptr}).first;
        kept->second.source = std::make_unique<const SourceText>(files.path_of(value), kept->second.content);
    }
    ++includes_;
    bytes_ += kept->second.content.size();
    if (includes_ > kMostIncludes || bytes_ > kMostBytes) {
        throw SceneError(name.place, fmt::format("file number {}, after {} bytes of text", includes_, bytes_),
                         fmt::format("a scene of at most {} files and {} bytes", kMostIncludes, kMostBytes));
    }
    open_.push_back({Lexer(*kept->second.source), kind, file});
    open_files_.insert(file);
}

std::string SceneTexts::cycle_of(const std::filesystem::path& file) const {
    constexpr std::size_t kFew = 5;
    std::string through;
    std::size_t between = 0;
    for (auto text = open_.rbegin(); text != open_.rend() && text->file != file; ++text, ++between) {
        if (between < kFew) through += (between == 0 ? "" : ", ") + quote(text->file.filename().string());
    }
    const std::string what = fmt::format("the file {} inside itself", quote(file.filename().string()));
    if (between == 0) return what;
    return fmt::format("{} (through {}{})", what, through,
                       between > kFew ? fmt::format(" and {} more", between - kFew) : "");
}

TextKind SceneTexts::close() {
    const TextKind kind = open_.back().kind;
    if (kind == TextKind::main) return kind;
    open_files_.erase(open_.back().file);
    open_.pop_back();
    return kind;
}

}  // namespace emulsion
