#include "cli/exr_output_options.h"

#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/named_option.h"

namespace emulsion::cli {

void add_exr_options(CLI::App& command, ExrOutput& output) {
    const auto set_space = [&output](const std::string& name) {
        output.options.space = name;
        try {
            validate(output.options);
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError("--space", error.what());
        }
    };
    CLI::Option* space =
        command
            .add_option_function<std::string>(
                "--space", set_space,
                fmt::format("Channels of the EXR: XYZ, or linear R G B of a space [default: {}]; one of\n  {}",
                            output.options.space, fmt::join(exr_space_names(), ", ")))
            ->option_text("NAME");
    const auto set_rgb = [&output, space] {
        if (space->count() > 0) throw CLI::ValidationError("--rgb", "found --space as well, expected one of the two");
        output.rgb = true;
    };
    command.add_flag_callback("--rgb", set_rgb,
                              "Short for --space sRGB, and not beside it: linear, with the primaries of Rec. 709");
    add_named_option(command, "--compression", "compression", output.options.compression, "Compression of the EXR");
    command.add_flag("--half", output.half, "Write 16-bit floats into the EXR [default: 32-bit ones]");
}

ExrOptions exr_options(const ExrOutput& output, PixelType pixel_type, int threads) {
    ExrOptions options = output.options;
    if (output.rgb) options.space = "sRGB";
    options.pixel_type = output.half ? PixelType::half : pixel_type;
    options.threads = threads;
    return options;
}

}  // namespace emulsion::cli
