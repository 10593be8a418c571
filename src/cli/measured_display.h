#pragma once
// The flags for a display as it was measured: primaries, white, and a table for its curve.

#include "develop/pipeline.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace emulsion::cli {

/// Adds --primaries and --white, which make the pipeline's display a custom one, with peak, black and flare of the
/// custom display that it was. They are read after `display`, and are bad usage beside any other display than custom,
/// of that flag or of the pipeline, but for the default.
void add_primaries_options(CLI::App& command, const CLI::Option& display, Pipeline& pipeline);

/// Adds --transfer-table, which sets the pipeline's transfer function, and is bad usage beside `transfer`.
void add_transfer_table_option(CLI::App& command, const CLI::Option& transfer, Pipeline& pipeline);

}  // namespace emulsion::cli
