#pragma once
// Short scene texts for the tests of the parser.

#include <string>
#include <string_view>
#include <variant>

#include "pathtracer/scene.h"
#include "pathtracer/scene_parser.h"

namespace emulsion::testing {

/// Parses text that is right.
inline Scene parse(std::string_view text) { return parse_scene(text, "t.pbrt"); }

/// The same with a world of its own.
inline Scene parse_world(const std::string& world) { return parse("WorldBegin\n" + world); }

/// The same with nothing but what stands before the world.
inline Scene parse_options(const std::string& options) { return parse(options + "\nWorldBegin\n"); }

/// The message for text that is wrong, or "(no error)".
inline std::string error_of(std::string_view text) {
    try {
        parse(text);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "(no error)";
}

/// The same for what stands in the second line, after WorldBegin.
inline std::string world_error_of(const std::string& world) { return error_of("WorldBegin\n" + world); }

inline const PerspectiveCamera& perspective(const Scene& scene) { return std::get<PerspectiveCamera>(scene.camera); }

/// The mesh of a scene's only shape.
inline TriangleMesh only_mesh(const Scene& scene) { return std::get<TriangleMesh>(scene.shapes.at(0).geometry); }

}  // namespace emulsion::testing
