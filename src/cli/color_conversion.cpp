#include "cli/color_conversion.h"

#include <array>
#include <string>

#include "core/named_value.h"
#include "spectrum/color_system.h"

namespace emulsion::cli {

namespace {

/// Where no white is given, that of the first RGB space that is named as a SPACE.
const SpaceArgument& reference_of(const ConversionArguments& arguments) {
    return arguments.from.rgb ? arguments.from : arguments.to;
}

}  // namespace

void add_conversion_options(CLI::App& command, ConversionArguments& arguments) {
    add_space_option(command, "--from", arguments.from, "System to convert from (emulsion color list spaces)");
    add_space_option(command, "--to", arguments.to, "System to convert to");
    add_context_options(command, arguments.context);
    command
        .add_option_function<std::string>(
            "--adapt",
            [&arguments](const std::string& text) {
                arguments.adaptation =
                    parse_for("--adapt", [&] { return parse_named<ChromaticAdaptation>(text, "adaptation"); });
            },
            "Chromatic adaptation from the white of the one system to that of the other (emulsion color list "
            "adaptations) [default: none]")
        ->option_text("NAME");
    command.footer(
        "SPACE is a colour system, or an RGB space by its name, for linear RGB of that space: sRGB is linear, and what "
        "most files hold is encoded-rgb. XYZ is relative, Y = 1 for the white. The white of RGB, and of what is made "
        "of it, is that of its RGB space; that of oklab, oklch, ipt and ictcp is D65; that of all others is --white.");
}

Conversion::Conversion(const ConversionArguments& arguments)
    : from_system_(arguments.from.system),
      to_system_(arguments.to.system),
      from_(arguments.context.context(arguments.from, reference_of(arguments))),
      to_(arguments.context.context(arguments.to, reference_of(arguments))) {
    if (!arguments.adaptation) return;
    adaptation_ = adaptation_matrix(*arguments.adaptation, white_of(from_system_, from_), white_of(to_system_, to_));
}

ColorValues Conversion::operator()(const ColorValues& color) const {
    XYZd xyz = to_xyz(from_system_, color, from_);
    if (adaptation_) {
        const auto [x, y, z] = *adaptation_ * std::array{xyz.x, xyz.y, xyz.z};
        xyz = {x, y, z};
    }
    return from_xyz(to_system_, xyz, to_);
}

}  // namespace emulsion::cli
