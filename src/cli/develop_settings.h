#pragma once
// What `emulsion develop` is told on its command line.

#include <filesystem>
#include <optional>
#include <vector>

#include "cli/distinct_files.h"
#include "develop/pipeline.h"
#include "display/png_compression.h"
#include "display/separation.h"
#include "spectrum/error_budget.h"

namespace CLI {
class App;
}

namespace emulsion::cli {

struct DevelopSettings {
    std::filesystem::path picture;
    std::filesystem::path output, contact_sheet, exposures, plates, print_preview, curve;  ///< empty if not given
    int threads = 0, png_level = kDefaultPngLevel;
    bool quiet = false, list_tonemaps = false, list_adaptations = false, show_pipeline = false;
    Pipeline pipeline;
    std::optional<ErrorBudget> auto_precision;  ///< of the fast way, where the picture is to choose
    BlackGeneration black;
};

/// Adds the flags, which are read into `settings`; it must outlive the parsing.
void add_develop_options(CLI::App& command, DevelopSettings& settings);

/// Those that were asked for, under their flags.
[[nodiscard]] std::vector<NamedFile> output_files(const DevelopSettings& settings);

}  // namespace emulsion::cli
