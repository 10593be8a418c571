// `emulsion color encode` and `emulsion color decode`: transfer functions on rows of numbers.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/color_tasks.h"
#include "cli/messages.h"
#include "cli/named_option.h"
#include "cli/number_rows.h"
#include "spectrum/transfer_function.h"

namespace emulsion::cli {

namespace {

struct Options {
    std::optional<std::filesystem::path> file;
    TransferFunction transfer;
};

ColorTask add_transfer(CLI::App& command, double (*apply)(const TransferFunction&, double) noexcept) {
    const auto options = std::make_shared<Options>();
    command
        .add_option("FILE", options->file, "Rows of numbers, as many as you like in a row; '-' or none: standard input")
        ->option_text(" ");
    add_named_option(command, "--transfer", "transfer", options->transfer, "Transfer function");
    return {&command, [options, apply] {
                NumberRows rows = read_number_rows(options->file, {});
                for (double& value : rows.values) value = apply(options->transfer, value);
                print_rows(rows);
            }};
}

}  // namespace

ColorTask add_color_encode(CLI::App& color) {
    return add_transfer(*color.add_subcommand("encode", "Linear values, proportional to light, to encoded ones"),
                        encode);
}

ColorTask add_color_decode(CLI::App& color) {
    return add_transfer(*color.add_subcommand("decode", "Encoded values to linear ones, proportional to light"),
                        decode);
}

}  // namespace emulsion::cli
