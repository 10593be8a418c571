// `emulsion color convert`: rows of one colour system to another, by way of XYZ.

#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "cli/color_arguments.h"
#include "cli/color_tasks.h"
#include "cli/number_rows.h"

namespace emulsion::cli {

namespace {

struct Options {
    std::optional<std::filesystem::path> file;
    SpaceArgument from, to;
    ContextArguments context;
};

std::vector<std::string_view> component_names(const ColorSystem& system) {
    std::vector<std::string_view> names;
    for (const ColorComponent& component : components_of(system)) names.push_back(component.name);
    return names;
}

void convert(const Options& options) {
    const ColorContext from = options.context.context(options.from, options.from.rgb ? options.from : options.to);
    const ColorContext to = options.context.context(options.to, options.from.rgb ? options.from : options.to);
    const NumberRows in = read_number_rows(options.file, component_names(options.from.system));
    NumberRows out{components_of(options.to.system).size(), {}, in.separator};
    for (std::size_t i = 0; i < in.size(); ++i) {
        ColorValues color;
        color.count = static_cast<int>(in.columns);
        std::copy(in.row(i).begin(), in.row(i).end(), color.value.begin());
        const ColorValues result = from_xyz(options.to.system, to_xyz(options.from.system, color, from), to);
        out.values.insert(out.values.end(), result.value.begin(), result.value.begin() + result.count);
    }
    print_rows(out);
}

}  // namespace

ColorTask add_color_convert(CLI::App& color) {
    CLI::App& command = *color.add_subcommand("convert", "Rows of one colour system to another, by way of XYZ");
    const auto options = std::make_shared<Options>();
    command.add_option("FILE", options->file, "Rows of numbers; '-' or none: standard input")->option_text(" ");
    add_space_option(command, "--from", options->from, "System of the rows read (emulsion color list spaces)");
    add_space_option(command, "--to", options->to, "System of the rows written");
    add_context_options(command, options->context);
    return {&command, [options] { convert(*options); }};
}

}  // namespace emulsion::cli
