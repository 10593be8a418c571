// `emulsion color matrix`: the 3x3 matrix between two linear systems.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/color_arguments.h"
#include "cli/color_tasks.h"
#include "cli/number_rows.h"
#include "core/matrix3.h"
#include "spectrum/chromatic_adaptation.h"

namespace emulsion::cli {

namespace {

struct Options {
    SpaceArgument from, to;
    ContextArguments context;
    std::optional<ChromaticAdaptation> adaptation;
};

/// The way from the one system to the other, adapted between the whites of their RGB spaces if asked for.
class Conversion {
  public:
    explicit Conversion(const Options& options)
        : from_system_(options.from.system),
          to_system_(options.to.system),
          from_(options.context.context(options.from, options.from)),
          to_(options.context.context(options.to, options.to)) {
        if (options.adaptation) adaptation_ = adaptation_matrix(*options.adaptation, from_.white(), to_.white());
    }

    [[nodiscard]] std::array<double, 3> operator()(const std::array<double, 3>& color) const {
        ColorValues values;
        std::copy(color.begin(), color.end(), values.value.begin());
        const XYZd xyz = to_xyz(from_system_, values, from_);
        const auto adapted = adaptation_ * std::array{xyz.x, xyz.y, xyz.z};
        const ColorValues result = from_xyz(to_system_, {adapted[0], adapted[1], adapted[2]}, to_);
        return {result.value[0], result.value[1], result.value[2]};
    }

  private:
    ColorSystem from_system_, to_system_;
    ColorContext from_, to_;
    Matrix3 adaptation_{{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}};
};

void require_three(const ColorSystem& system) {
    if (components_of(system).size() == 3) return;
    throw std::invalid_argument(fmt::format("{} has four components, expected a system of three", to_text(system)));
}

/// Column i of the matrix is what the i-th unit vector becomes.
NumberRows matrix_of(const Options& options) {
    require_three(options.from.system);
    require_three(options.to.system);
    const Conversion convert(options);
    NumberRows matrix{3, std::vector<double>(9), ' '};
    for (std::size_t column = 0; column < 3; ++column) {
        std::array<double, 3> unit{};
        unit[column] = 1.0;
        const std::array<double, 3> image = convert(unit);
        for (std::size_t row = 0; row < 3; ++row) matrix.values[3 * row + column] = image[row];
    }

    // Only a linear way is a matrix: it must then do the same to any colour.
    constexpr std::array kProbe = {0.3, -0.2, 0.7};
    const std::array<double, 3> image = convert(kProbe);
    for (std::size_t row = 0; row < 3; ++row) {
        const auto m = matrix.row(row);
        const double product = m[0] * kProbe[0] + m[1] * kProbe[1] + m[2] * kProbe[2];
        if (!(std::abs(product - image[row]) <= 1e-12 * (std::abs(m[0]) + std::abs(m[1]) + std::abs(m[2])))) {
            throw std::invalid_argument(fmt::format("{} to {} is not linear: expected two systems that a matrix joins",
                                                    to_text(options.from.system), to_text(options.to.system)));
        }
    }
    return matrix;
}

}  // namespace

ColorTask add_color_matrix(CLI::App& color) {
    CLI::App& command = *color.add_subcommand("matrix", "The matrix between two linear systems, row by row");
    const auto options = std::make_shared<Options>();
    add_space_option(command, "--from", options->from, "A linear system: xyz, rgb, an RGB space by name, lms-...");
    add_space_option(command, "--to", options->to, "Another");
    add_context_options(command, options->context);
    command
        .add_option_function<std::string>(
            "--adapt",
            [options](const std::string& text) {
                options->adaptation =
                    parse_for("--adapt", [&] { return parse_named<ChromaticAdaptation>(text, "adaptation"); });
            },
            "Chromatic adaptation from the one RGB space's white to the other's (emulsion color list adaptations) "
            "[default: none]")
        ->option_text("NAME");
    return {&command, [options] { print_rows(matrix_of(*options)); }};
}

}  // namespace emulsion::cli
