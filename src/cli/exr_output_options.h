#pragma once
// The flags for what an EXR is to be like, shared by the subcommands that write one.

#include <optional>
#include <string>

#include "cli/film_files.h"
#include "compare/pixel_choice.h"
#include "film/exr_file.h"

namespace CLI {
class App;
}

namespace emulsion::cli {

/// What the flags said.
struct ExrOutput {
    ExrOptions options;
    bool rgb = false, half = false;
    std::optional<PixelChoice> pixels;  ///< none: half, or what is the default
};

/// Adds --space, --rgb, --pixels, --half and --compression to a subcommand; parsing sets `output`, which must outlive
/// it.
void add_exr_options(CLI::App& command, ExrOutput& output);

/// Of what was parsed; `pixel_type` is the one without --pixels and --half. Float if that is to be decided.
[[nodiscard]] ExrOptions exr_options(const ExrOutput& output, PixelType pixel_type, int threads);

/// What decides then.
[[nodiscard]] AutoPixelType auto_pixels(const ExrOutput& output, bool quiet);

}  // namespace emulsion::cli
