// `emulsion color convert`: rows of one colour system to another, by way of XYZ.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/color_conversion.h"
#include "cli/color_tasks.h"
#include "cli/number_rows.h"
#include "spectrum/color_system.h"

namespace emulsion::cli {

namespace {

struct Options {
    std::optional<std::filesystem::path> file;
    ConversionArguments conversion;
};

std::vector<std::string_view> component_names(const ColorSystem& system) {
    std::vector<std::string_view> names;
    for (const ColorComponent& component : components_of(system)) names.push_back(component.name);
    return names;
}

void convert_rows(const Options& options) {
    const Conversion convert(options.conversion);
    const NumberRows in = read_number_rows(options.file, component_names(options.conversion.from.system));
    NumberRows out{components_of(options.conversion.to.system).size(), {}, in.separator};
    for (std::size_t i = 0; i < in.size(); ++i) {
        ColorValues color;
        color.count = static_cast<int>(in.columns);
        std::copy(in.row(i).begin(), in.row(i).end(), color.value.begin());
        const ColorValues result = convert(color);
        out.values.insert(out.values.end(), result.value.begin(), result.value.begin() + result.count);
    }
    print_rows(out);
}

}  // namespace

ColorTask add_color_convert(CLI::App& color) {
    CLI::App& command = *color.add_subcommand("convert", "Rows of one colour system to another, by way of XYZ");
    const auto options = std::make_shared<Options>();
    command.add_option("FILE", options->file, "Rows of numbers; '-' or none: standard input")->option_text(" ");
    add_conversion_options(command, options->conversion);
    return {&command, [options] { convert_rows(*options); }};
}

}  // namespace emulsion::cli
