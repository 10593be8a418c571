#pragma once
// The Option directive: settings that pbrt-v4 also takes on its command line. It writes Option "seed" 7; the form of
// parameters, Option "integer seed" [ 7 ], is taken as well.

#include <string>

#include "pathtracer/scene.h"
#include "pathtracer/scene_lexer.h"

namespace emulsion {

struct GlobalOptions {
    int seed = 0;  ///< of samplers that give none
    SampleJitter jitter;
};

/// Reads one, into `options` if it matters here.
/// \returns what to warn of: the option's name if it has no effect here; empty: nothing.
/// \throws SceneError naming the token at fault.
[[nodiscard]] std::string read_global_option(const Token& name, const Token& value, GlobalOptions& options);

}  // namespace emulsion
