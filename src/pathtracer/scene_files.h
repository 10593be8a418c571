#pragma once
// The files that a scene names: included scenes, spectra, meshes, images. Relative names are looked for in the folder
// of the main scene file, as pbrt-v4 does, wherever the file lies that names them.

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/content_hash.h"
#include "pathtracer/scene_source.h"

namespace emulsion {

class SceneFiles {
  public:
    /// `folder` is that of the main scene file.
    explicit SceneFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    [[nodiscard]] std::filesystem::path path_of(std::string_view name) const { return folder_ / name; }

    /// The bytes of the file; if its name ends with ".gz", what they stand for (pathtracer/gzip.h). Notes that it was
    /// read. \throws IoError if that fails.
    [[nodiscard]] std::string read(std::string_view name);
    /// The same. \throws SceneError if that fails: `place` is that of the token that names the file.
    [[nodiscard]] std::string read(const SourcePlace& place, std::string_view name);

    /// A fingerprint of the contents of the files that were read, in the order of reading.
    [[nodiscard]] std::string hash() const { return contents_.hex(); }
    /// The files that were read, each once, in the order of first reading.
    [[nodiscard]] const std::vector<std::filesystem::path>& list() const noexcept { return list_; }

  private:
    std::filesystem::path folder_;
    ContentHash contents_;
    std::vector<std::filesystem::path> list_;
    std::set<std::filesystem::path> listed_;
};

}  // namespace emulsion
