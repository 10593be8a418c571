#pragma once
// From one colour system to another, as `emulsion color convert` and `matrix` take it from the command line.

#include <optional>

#include <CLI/CLI.hpp>

#include "cli/color_arguments.h"
#include "core/matrix3.h"
#include "spectrum/chromatic_adaptation.h"
#include "spectrum/color_values.h"

namespace emulsion::cli {

/// The flags --from, --to, --rgb-space, --white, --transfer and --adapt.
struct ConversionArguments {
    SpaceArgument from, to;
    ContextArguments context;
    std::optional<ChromaticAdaptation> adaptation;  ///< none: XYZ stays as it is
};

/// Adds the flags; parsing fills `arguments`, which must outlive it.
void add_conversion_options(CLI::App& command, ConversionArguments& arguments);

/// The way from the one system to the other by XYZ; adapted, if asked for, from the white of the one to that of the
/// other.
class Conversion {
  public:
    /// \throws std::invalid_argument as adaptation_matrix does.
    explicit Conversion(const ConversionArguments& arguments);

    /// \param color with as many components as the first system
    [[nodiscard]] ColorValues operator()(const ColorValues& color) const;

  private:
    ColorSystem from_system_, to_system_;
    ColorContext from_, to_;
    std::optional<Matrix3> adaptation_;
};

}  // namespace emulsion::cli
