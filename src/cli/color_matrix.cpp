// `emulsion color matrix`: the 3x3 matrix between two linear systems.

#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/color_conversion.h"
#include "cli/color_tasks.h"
#include "cli/number_rows.h"
#include "spectrum/color_system.h"

namespace emulsion::cli {

namespace {

void require_three(const ColorSystem& system) {
    if (components_of(system).size() == 3) return;
    throw std::invalid_argument(fmt::format("{} has four components, expected a system of three", to_text(system)));
}

/// Column i of the matrix is what the i-th unit vector becomes.
NumberRows matrix_of(const ConversionArguments& arguments) {
    require_three(arguments.from.system);
    require_three(arguments.to.system);
    const Conversion convert(arguments);
    NumberRows matrix{3, std::vector<double>(9), ' '};
    for (std::size_t column = 0; column < 3; ++column) {
        ColorValues unit;
        unit.value[column] = 1.0;
        const ColorValues image = convert(unit);
        for (std::size_t row = 0; row < 3; ++row) matrix.values[3 * row + column] = image.value[row];
    }

    // Only a linear way is a matrix: it must then do the same to any colour.
    constexpr ColorValues kProbe = {{0.3, -0.2, 0.7}};
    const ColorValues image = convert(kProbe);
    for (std::size_t row = 0; row < 3; ++row) {
        const auto m = matrix.row(row);
        const double product = m[0] * kProbe.value[0] + m[1] * kProbe.value[1] + m[2] * kProbe.value[2];
        if (!(std::abs(product - image.value[row]) <= 1e-12 * (std::abs(m[0]) + std::abs(m[1]) + std::abs(m[2])))) {
            throw std::invalid_argument(fmt::format("{} to {} is not linear: expected two systems that a matrix joins",
                                                    to_text(arguments.from.system), to_text(arguments.to.system)));
        }
    }
    return matrix;
}

}  // namespace

ColorTask add_color_matrix(CLI::App& color) {
    CLI::App& command = *color.add_subcommand("matrix", "The matrix between two linear systems, row by row");
    const auto arguments = std::make_shared<ConversionArguments>();
    add_conversion_options(command, *arguments);
    return {&command, [arguments] { print_rows(matrix_of(*arguments)); }};
}

}  // namespace emulsion::cli
