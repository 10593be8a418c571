#pragma once
// --precision of `emulsion develop`: fast, reference, or what the picture needs.

#include "cli/develop_settings.h"
#include "core/color.h"
#include "core/image.h"

namespace CLI {
class App;
}

namespace emulsion::cli {

/// Adds the flag, after --pipeline, before which it goes. `settings` must outlive the parsing.
void add_precision_option(CLI::App& command, DevelopSettings& settings);

/// If the flag left it to the picture, finds out and says so, with the time that this took, unless all is to be quiet.
/// The settings' pipeline then has what was found.
void resolve_precision(const Image<XYZ>& picture, DevelopSettings& settings);

}  // namespace emulsion::cli
