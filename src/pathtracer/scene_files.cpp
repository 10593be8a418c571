#include "pathtracer/scene_files.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/text_file.h"
#include "pathtracer/gzip.h"

namespace emulsion {

std::string SceneFiles::read(std::string_view name) {
    const std::filesystem::path path = path_of(name);
    std::string content = read_text_file(path);
    if (path.extension() == ".gz") content = inflate_gzip(path, content);
    // With its size, so that the end of one file and the beginning of the next don't pass for each other.
    contents_.add(fmt::format("{}:", content.size()));
    contents_.add(content);
    if (listed_.insert(path).second) list_.push_back(path);
    return content;
}

std::string SceneFiles::read(const SourcePlace& place, std::string_view name) {
    try {
        return read(name);
    } catch (const IoError& error) {
        throw SceneError(place, fmt::format("the file {} ({})", quote(name), error.reason()), "one that can be read");
    }
}

}  // namespace emulsion
