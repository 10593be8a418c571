#pragma once
// What the `emulsion color` commands take as words: colour spaces, whites, and what they are relative to.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "core/color.h"
#include "spectrum/color_context.h"
#include "spectrum/color_system.h"
#include "spectrum/observer.h"
#include "spectrum/spectrum.h"

namespace emulsion::cli {

/// SPACE on the command line: a colour system ("lab", "hsv"), or the name of an RGB space for linear RGB of that space.
struct SpaceArgument {
    ColorSystem system;
    std::optional<RgbSpace> rgb;  ///< the space, where the text names one
};

/// \throws std::invalid_argument for an unknown name, with the names most like it.
[[nodiscard]] SpaceArgument parse_space(std::string_view text);

/// The illuminant of this name. \throws std::invalid_argument for an unknown name and a spectrum that is none.
[[nodiscard]] Spectrum parse_illuminant(std::string_view text);

/// NAME or x,y: the chromaticity of an illuminant of the catalogue, by its exact integral, or as given.
/// \throws std::invalid_argument as parse_illuminant does, for malformed numbers, and for what can't be a white.
[[nodiscard]] Chromaticity parse_white(std::string_view text, const Observer& observer = cie_1931_2deg());

/// The flags --rgb-space, --white and --transfer.
struct ContextArguments {
    std::string rgb_space = "sRGB";
    std::optional<Chromaticity> white;
    TransferFunction transfer;

    /// For numbers in `space`. Unless it is given, the white is that of `reference`'s RGB space, if that names one,
    /// else that of --rgb-space.
    [[nodiscard]] ColorContext context(const SpaceArgument& space, const SpaceArgument& reference) const;
};

/// Adds the flags; parsing fills `arguments`, which must outlive it.
void add_context_options(CLI::App& command, ContextArguments& arguments);

/// Runs `parse`; the std::invalid_argument that it throws becomes bad usage of the flag.
template <class Parse>
auto parse_for(const std::string& flag, const Parse& parse) {
    try {
        return parse();
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError(flag, error.what());
    }
}

/// Adds the required flag `flag` SPACE.
void add_space_option(CLI::App& command, const std::string& flag, SpaceArgument& space, const std::string& help);

/// Adds a flag NAME|x,y that sets `white`.
CLI::Option* add_white_option(CLI::App& command, const std::string& flag, std::optional<Chromaticity>& white,
                              const std::string& help);

}  // namespace emulsion::cli
