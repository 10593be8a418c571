#include "cli/precision_option.h"

#include <chrono>
#include <string>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/messages.h"
#include "cli/named_option.h"
#include "compare/precision_choice.h"

namespace emulsion::cli {

void add_precision_option(CLI::App& command, DevelopSettings& settings) {
    const auto set = [&settings](const std::string& text) {
        const PrecisionChoice choice = parse_named_option("--precision", [&] { return parse_precision_choice(text); });
        if (const auto* wish = std::get_if<AutoPrecision>(&choice)) {
            settings.auto_precision = wish->budget;
        } else {
            settings.pipeline.precision = std::get<Precision>(choice);
        }
    };
    std::string help =
        fmt::format("Bloom, vision and tone mapping [default: {}]; one of", to_text(settings.pipeline.precision));
    for (const NamedValueDescription& choice : describe_named<Precision>()) {
        help += fmt::format("\n  {}: {}", choice.name, choice.help);
        if (choice.name != ReferencePrecision::kName) continue;
        // docs/tone-mapping.md has the measurements.
        help +=
            "; 4 to 17 times as long, 60 to 3000 times under local adaptations, with bloom or vision hours for a "
            "megapixel; two more pictures in memory";
    }
    help += fmt::format(
        "\n  auto[:MEAN[,P99]]: fast if its colour error on the display, CIEDE2000, is within a mean and a 99th "
        "percentile [{:g},{:g}] on the picture made smaller, to 256 pixels at most in width and in height, with "
        "bloom or vision to 96; else reference",
        ErrorBudget{}.mean, ErrorBudget{}.p99);
    command.add_option_function<std::string>("--precision", set, help)->option_text("NAME");
}

void resolve_precision(const Image<XYZ>& picture, DevelopSettings& settings) {
    if (!settings.auto_precision) return;
    const auto begun = std::chrono::steady_clock::now();
    const PrecisionLoss loss = precision_loss(picture, settings.pipeline, {.threads = settings.threads});
    const PrecisionDecision decision = decide_precision(loss, *settings.auto_precision);
    const double taken_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    settings.pipeline.precision = decision.precision;
    if (!settings.quiet) print_output(fmt::format("{}; found in {:.2g} s\n", decision.reason, taken_s));
}

}  // namespace emulsion::cli
