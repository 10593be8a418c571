#include "cli/chart_command.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "chart/chart_csv.h"
#include "chart/charts.h"
#include "chart/gnuplot.h"
#include "cli/distinct_files.h"
#include "cli/file_names.h"
#include "cli/messages.h"
#include "cli/option_checks.h"
#include "core/atomic_file.h"
#include "core/name_key.h"
#include "core/text_file.h"

namespace emulsion::cli {

struct ChartCommand::Options {
    std::string name;
    std::filesystem::path drawing, csv, from;
    ChartOptions measuring;
};

namespace {

std::string kind_names() {
    std::string names;
    for (const ChartKind& kind : chart_kinds()) names += fmt::format("{}{}", names.empty() ? "" : ", ", kind.name);
    return names;
}

std::string charts_help() {
    std::string help = "Charts:";
    for (const ChartKind& kind : chart_kinds()) {
        help += fmt::format("\n  {:<14} {}", kind.name, kind.help);
        if (kind.scenes == ChartScenes::needed) help += "; needs --scene";
    }
    return help;
}

std::string ends_in_svg_or_png(const std::string& name) {
    if (has_extension(name, ".svg") || has_extension(name, ".png")) return {};
    return found_expected(name, "a name ending in .svg or .png");
}

void check_options(const std::string& name, const std::filesystem::path& drawing, const std::filesystem::path& csv,
                   const std::filesystem::path& from, const ChartOptions& measuring) {
    require_distinct({{"--from", from}, {"-o", drawing}, {"--csv", csv}});
    if (!from.empty()) {
        if (!name.empty()) throw CLI::ValidationError("NAME", "is of a chart to measure, and --from has one already");
        if (drawing.empty()) throw CLI::ValidationError("--from", "needs -o, the picture to draw");
        return;
    }
    const auto kinds = chart_kinds();
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const ChartKind& candidate) {
        return name_key(candidate.name) == name_key(name);
    });
    if (kind == kinds.end()) {
        throw CLI::ValidationError("NAME", name.empty() ? "missing, expected one of " + kind_names()
                                                        : found_expected(name, "one of " + kind_names()));
    }
    const bool needs_scenes = kind->scenes == ChartScenes::needed;
    if (needs_scenes && measuring.scenes.empty()) {
        throw CLI::ValidationError("--scene", fmt::format("missing, and the chart \"{}\" is of scenes", name));
    }
    for (auto scene = measuring.scenes.begin(); scene != measuring.scenes.end(); ++scene) {
        if (std::count(scene, measuring.scenes.end(), *scene) > 1) {
            throw CLI::ValidationError("--scene", fmt::format("{} is given twice", scene->string()));
        }
    }
    if (!needs_scenes && !measuring.scenes.empty()) {
        throw CLI::ValidationError("--scene", fmt::format("the chart \"{}\" is not of scenes", name));
    }
}

}  // namespace

ChartCommand::ChartCommand(CLI::App& program)
    : command_(program.add_subcommand("chart", "Measure what approximations cost and lose, and draw it")),
      options_(std::make_unique<Options>()) {
    Options& options = *options_;
    command_->footer(charts_help());
    command_->add_option("NAME", options.name, "Which chart, of those below")->option_text(" ");
    command_
        ->add_option("-o,--output", options.drawing,
                     "Draw it, by gnuplot (Debian's package gnuplot-nox) [default: the CSV alone]")
        ->check(ends_in_svg_or_png)
        ->option_text("FILE.svg|FILE.png");
    command_
        ->add_option("--csv", options.csv, "Write the points there [default: to standard output, unless -o is given]")
        ->option_text("FILE.csv");
    command_->add_option("--from", options.from, "Draw the points of a file that --csv wrote; nothing is measured")
        ->option_text("FILE.csv");
    command_
        ->add_option("--scene", options.measuring.scenes, "Scene file in pbrt-v4 syntax; may be given several times")
        ->option_text("FILE.pbrt");
    command_->add_flag_callback(
        "--quick", [&options] { options.measuring.effort = ChartEffort::quick; },
        "Fewer sizes and repetitions: seconds, and rough [default: minutes]");
    add_threads_option(*command_, options.measuring.threads);
    command_->final_callback(
        [&options] { check_options(options.name, options.drawing, options.csv, options.from, options.measuring); });
}

ChartCommand::~ChartCommand() = default;

bool ChartCommand::chosen() const { return command_->parsed(); }

int ChartCommand::run() const {
    const Options& options = *options_;
    for (const std::filesystem::path& path : {options.drawing, options.csv}) {
        if (!path.empty()) check_writable(path);
    }
    if (!options.drawing.empty()) check_gnuplot();
    const Chart chart = options.from.empty() ? measure_chart(options.name, options.measuring)
                                             : parse_chart_csv(read_text_file(options.from), options.from);
    if (!options.csv.empty()) write_text_file(options.csv, to_csv(chart));
    if (options.csv.empty() && options.drawing.empty()) print_output(to_csv(chart));
    if (!options.drawing.empty()) draw_chart(chart, options.drawing);
    return kDone;
}

}  // namespace emulsion::cli
