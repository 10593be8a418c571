// `emulsion color difference`: how far apart two colours are.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>

#include <CLI/CLI.hpp>

#include "cli/color_tasks.h"
#include "cli/difference_method.h"
#include "cli/named_option.h"
#include "cli/number_rows.h"

namespace emulsion::cli {

namespace {

struct Options {
    std::optional<std::filesystem::path> file;
    DifferenceMethod method;
};

/// The kind of colour that a method compares, by the names of its components for a pair.
template <class Method>
struct ColorOf {
    using Color = Lab;
    static constexpr std::array<std::string_view, 6> kColumns = {"L1", "a1", "b1", "L2", "a2", "b2"};
};
template <>
struct ColorOf<ItpDifference> {
    using Color = ICtCp;
    static constexpr std::array<std::string_view, 6> kColumns = {"I1", "Ct1", "Cp1", "I2", "Ct2", "Cp2"};
};

void print_differences(const Options& options) {
    std::visit(
        [&]<class Method>(const Method& method) {
            using Color = typename ColorOf<Method>::Color;
            const NumberRows pairs = read_number_rows(options.file, ColorOf<Method>::kColumns);
            NumberRows differences{1, {}, ' '};
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                const auto row = pairs.row(i);
                const Color reference{row[0], row[1], row[2]}, sample{row[3], row[4], row[5]};
                differences.values.push_back(difference(method, reference, sample));
            }
            print_rows(differences);
        },
        options.method);
}

}  // namespace

ColorTask add_color_difference(CLI::App& color) {
    CLI::App& command = *color.add_subcommand("difference", "How far apart two colours are: a number for each row");
    const auto options = std::make_shared<Options>();
    command
        .add_option("FILE", options->file,
                    "Rows of two CIELAB colours, the reference first (itp: two ICtCp colours); '-' or none: standard "
                    "input")
        ->option_text(" ");
    add_named_option(command, "--method", "difference", options->method, "Formula");
    return {&command, [options] { print_differences(*options); }};
}

}  // namespace emulsion::cli
