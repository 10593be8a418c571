#pragma once
// What `emulsion compare` is told on its command line.

#include <filesystem>
#include <optional>
#include <string>

#include "cli/compare_input.h"
#include "develop/pipeline.h"

namespace CLI {
class App;
}

namespace emulsion::cli {

/// CIEDE2000 that may not be exceeded.
struct DifferenceLimits {
    double mean = 0.0;
    std::optional<double> p99 = std::nullopt;
};

struct CompareSettings {
    CompareInput a, b;
    SceneRenderSettings scenes;
    std::optional<std::string> white;  ///< NAME or x,y
    std::optional<double> white_luminance_cdm2;
    Pipeline pipeline;
    std::filesystem::path map;  ///< empty if not given
    std::optional<double> map_end;
    std::optional<DifferenceLimits> limits;
    bool json = false;
};

/// Adds the flags, which are read into `settings`; it must outlive the parsing.
void add_compare_options(CLI::App& command, CompareSettings& settings);

}  // namespace emulsion::cli
