// `emulsion color adapt`: XYZ under one white to XYZ that looks the same under another.

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "cli/color_arguments.h"
#include "cli/color_tasks.h"
#include "cli/named_option.h"
#include "cli/number_rows.h"
#include "core/parameters.h"
#include "spectrum/chromatic_adaptation.h"

namespace emulsion::cli {

namespace {

struct Options {
    std::optional<std::filesystem::path> file;
    std::optional<Chromaticity> from, to;
    ChromaticAdaptation method;
    double degree = 1.0;
};

void adapt(const Options& options) {
    const Matrix3 matrix =
        adaptation_matrix(options.method, xyz_of(*options.from), xyz_of(*options.to), options.degree);
    constexpr std::array<std::string_view, 3> kColumns = {"X", "Y", "Z"};
    NumberRows rows = read_number_rows(options.file, kColumns);
    for (std::size_t i = 0; i < rows.values.size(); i += 3) {
        const auto adapted = matrix * std::array{rows.values[i], rows.values[i + 1], rows.values[i + 2]};
        std::copy(adapted.begin(), adapted.end(), rows.values.begin() + static_cast<std::ptrdiff_t>(i));
    }
    print_rows(rows);
}

}  // namespace

ColorTask add_color_adapt(CLI::App& color) {
    CLI::App& command = *color.add_subcommand("adapt", "XYZ under one white to XYZ that looks the same under another");
    const auto options = std::make_shared<Options>();
    command.add_option("FILE", options->file, "Rows of X Y Z; '-' or none: standard input")->option_text(" ");
    add_white_option(command, "--from", options->from, "White that the rows are seen under [required]")->required();
    add_white_option(command, "--to", options->to, "White to adapt to [required]")->required();
    add_named_option(command, "--method", "adaptation", options->method, "Chromatic adaptation");
    command
        .add_option_function<std::string>(
            "--degree",
            [options](const std::string& text) {
                parse_for("--degree", [&] {
                    parse_number(text, "degree", options->degree);
                    check_range(options->degree, {0.0, 1.0}, "degree");
                });
            },
            "Degree of adaptation, 0 to 1 [default: 1]")
        ->option_text("D");
    return {&command, [options] { adapt(*options); }};
}

}  // namespace emulsion::cli
