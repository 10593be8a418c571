#include "cli/file_names.h"

#include <algorithm>
#include <string>

namespace emulsion::cli {

namespace {

/// Of ASCII; the bytes of any other letter stay.
std::string in_small_letters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

}  // namespace

bool has_extension(const std::filesystem::path& name, std::string_view extension) {
    return in_small_letters(name.extension().string()) == extension;
}

bool is_state_name(const std::filesystem::path& name) {
    return in_small_letters(name.filename().string()).ends_with(".film.exr");
}

std::filesystem::path state_name(const std::filesystem::path& output) {
    if (is_state_name(output)) return output;
    std::filesystem::path state = output;
    return state.replace_extension(".film.exr");
}

}  // namespace emulsion::cli
