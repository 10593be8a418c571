#pragma once
// What a scene is warned of: the first few of each kind, as a scene of a million shapes may be a million times odd in
// the same way.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "pathtracer/scene_source.h"

namespace emulsion {

class SceneWarnings {
  public:
    /// Of one kind. The last of them tells how many more there were.
    static constexpr std::size_t kShown = 8;

    /// `place` is where what the scene says is taken otherwise. Warnings are of one kind if they differ in numbers, in
    /// what is quoted and in what follows in brackets only.
    void add(const SourcePlace& place, const std::string& what);

    /// "file:line:column: what", in the order added.
    [[nodiscard]] std::vector<std::string> list() const;

  private:
    struct Kind {
        std::size_t count = 0;
        std::size_t last_shown = 0;  // in shown_
    };
    std::vector<std::string> shown_;
    std::map<std::string, Kind> kinds_;
};

}  // namespace emulsion
