#include "cli/compare_command.h"

#include <filesystem>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/color_arguments.h"
#include "cli/compare_input.h"
#include "cli/compare_report.h"
#include "cli/compare_settings.h"
#include "cli/messages.h"
#include "compare/compare.h"
#include "compare/difference_map.h"
#include "core/atomic_file.h"
#include "display/png_file.h"

namespace emulsion::cli {

namespace {

void write_map(const CompareSettings& settings, const Comparison& comparison) {
    const Image<CodeRGB> map =
        difference_map(comparison.ciede2000_pixels, comparison.ciede2000, {.end = settings.map_end});
    write_png(
        settings.map, map,
        {.text = {{"Software", "Emulsion"}, {"Title", "CIEDE2000 of " + settings.a.text + " and " + settings.b.text}}});
}

}  // namespace

struct CompareCommand::Options : CompareSettings {};

CompareCommand::CompareCommand(CLI::App& program)
    : command_(program.add_subcommand("compare", "Say how far two pictures are apart, and how much of it is noise")),
      options_(std::make_unique<Options>()) {
    add_compare_options(*command_, *options_);
}

CompareCommand::~CompareCommand() = default;

bool CompareCommand::chosen() const { return command_->parsed(); }

int CompareCommand::run() const {
    const CompareSettings& settings = *options_;
    if (!settings.map.empty()) check_writable(settings.map);
    const ComparedPicture a = compare_input(settings.a, CompareSide::a, settings.scenes);
    const ComparedPicture b = compare_input(settings.b, CompareSide::b, settings.scenes);
    CompareOptions options{.white_luminance_cdm2 = settings.white_luminance_cdm2,
                           .pipeline = settings.pipeline,
                           .threads = settings.scenes.threads};
    if (settings.white) options.white = parse_white(*settings.white, observer(a.observer));
    const Comparison comparison = compare(a, b, options);

    if (!settings.map.empty()) write_map(settings, comparison);
    const InfoReport report = report_of({settings, a, b, comparison});
    print_output(settings.json ? report.json() : report.text());
    if (!settings.limits) return kDone;
    const std::vector<std::string> reasons = exceeded(*settings.limits, comparison);
    if (reasons.empty()) return kDone;
    flush_output();
    print_error(fmt::format("{}", fmt::join(reasons, "; ")));
    return kFailed;
}

}  // namespace emulsion::cli
