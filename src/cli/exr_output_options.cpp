#include "cli/exr_output_options.h"

#include <stdexcept>
#include <variant>

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
    const CLI::Option* pixels =
        command
            .add_option_function<std::string>(
                "--pixels",
                [&output](const std::string& text) {
                    output.pixels = parse_named_option("--pixels", [&] { return parse_pixel_choice(text); });
                },
                fmt::format(
                    "Numbers in the EXR [default: the scene's, or float]; one of\n"
                    "  half: of 16 bits, up to 65504 and with 11 bits of precision\n"
                    "  float: of 32 bits\n"
                    "  auto[:MEAN[,P99]]: half if its colour error in this picture, CIEDE2000, is within a mean "
                    "and a 99th percentile [{:g},{:g}], nothing overflows or becomes 0, and no layer is "
                    "damaged; else float, as of a film state, whose sums are exact whatever is chosen",
                    ErrorBudget{}.mean, ErrorBudget{}.p99))
            ->option_text("NAME");
    const auto set_half = [&output, pixels] {
        if (pixels->count() > 0)
            throw CLI::ValidationError("--half", "found --pixels as well, expected one of the two");
        output.half = true;
    };
    command.add_flag_callback("--half", set_half, "Short for --pixels half, and not beside it");
}

ExrOptions exr_options(const ExrOutput& output, PixelType pixel_type, int threads) {
    ExrOptions options = output.options;
    if (output.rgb) options.space = "sRGB";
    options.pixel_type = output.half ? PixelType::half : pixel_type;
    if (output.pixels) {
        const auto* chosen = std::get_if<PixelType>(&*output.pixels);
        options.pixel_type = chosen != nullptr ? *chosen : PixelType::float32;
    }
    options.threads = threads;
    return options;
}

AutoPixelType auto_pixels(const ExrOutput& output, bool quiet) {
    const auto* wish = output.pixels ? std::get_if<AutoPixels>(&*output.pixels) : nullptr;
    return {.budget = wish != nullptr ? std::optional(wish->budget) : std::nullopt, .quiet = quiet};
}

}  // namespace emulsion::cli
