#pragma once
// The flags for what an EXR is to be like, shared by the subcommands that write one.

#include <string>

#include "film/exr_file.h"

namespace CLI {
class App;
}

namespace emulsion::cli {

/// What the flags said.
struct ExrOutput {
    ExrOptions options;
    bool rgb = false, half = false;
};

/// Adds --space, --rgb, --half and --compression to a subcommand; parsing sets `output`, which must outlive it.
void add_exr_options(CLI::App& command, ExrOutput& output);

/// Of what was parsed; `pixel_type` is the one without --half.
[[nodiscard]] ExrOptions exr_options(const ExrOutput& output, PixelType pixel_type, int threads);

}  // namespace emulsion::cli
