#pragma once

#include <exception>
#include <filesystem>
#include <string>

namespace emulsion {

/// The reason of an IoError about a file that OpenEXR could not read. OpenEXR names the file in the middle of its
/// messages, and may use several lines; ours has one, and the name before it.
[[nodiscard]] inline std::string exr_reason(const std::exception& error, const std::filesystem::path& path) {
    std::string message = error.what();
    const std::string name = "\"" + path.string() + "\". ";
    if (const auto at = message.find(name); at != std::string::npos) {
        message = "cannot read: " + message.substr(at + name.size());
    }
    for (char& c : message) {
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    return message;
}

}  // namespace emulsion
