#include "cli/analyze_command.h"

#include <filesystem>
#include <string>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/model_choice.h"
#include "cli/json_text.h"
#include "cli/messages.h"
#include "cli/named_option.h"
#include "cli/option_checks.h"
#include "pathtracer/scene_parser.h"

namespace emulsion::cli {

struct AnalyzeCommand::Options {
    std::filesystem::path scene;
    ErrorBudget budget;
    int threads = 0;
    bool json = false;
};

namespace {

/// "1" or "1,3", as behind --model auto:
ErrorBudget parse_budget(const std::string& text) {
    return parse_named_option("--budget",
                              [&] { return std::get<AutoModel>(parse_model_choice("auto:" + text)).budget; });
}

std::string text_of(const ModelAnalysis& analysis) {
    std::string text =
        fmt::format("  {:<28} {:>9} {:>9} {:>6} {:>7}\n", "model", "dE00 mean", "dE00 p99", "cost", "noise");
    for (std::size_t i = 0; i < analysis.models.size(); ++i) {
        const ModelPrediction& p = analysis.models[i];
        const std::string mean = p.error ? fmt::format("{:.2f}", p.error->mean) : "-";
        const std::string p99 = p.error ? fmt::format("{:.2f}", p.error->p99) : "-";
        text += fmt::format("{} {:<28} {:>9} {:>9} {:>6.2f} {:>7.2f}\n", i == analysis.chosen ? '*' : ' ',
                            to_text(p.model), mean, p99, p.cost, p.noise);
    }
    text += fmt::format("light that dispersed: {:.2f} %\n", 100.0 * analysis.dispersed_share);
    return text + reasons(analysis) + "\n";
}

std::string json_error(const ModelPrediction& prediction, double ColourError::*part) {
    return prediction.error ? json_number((*prediction.error).*part) : "null";
}

std::string json_of(const ModelAnalysis& analysis) {
    std::string models;
    for (const ModelPrediction& p : analysis.models) {
        models += fmt::format(
            "{}\n    {{\"model\": {}, \"mean\": {}, \"p99\": {}, \"cost\": {}, \"noise\": {}, \"good_enough\": {}}}",
            models.empty() ? "" : ",", json_text(to_text(p.model)), json_error(p, &ColourError::mean),
            json_error(p, &ColourError::p99), json_number(p.cost), json_number(p.noise), p.good_enough);
    }
    return fmt::format(
        "{{\n  \"budget\": {{\"mean\": {}, \"p99\": {}}},\n  \"dispersed_share\": {},\n  \"chosen\": {},\n  "
        "\"reasons\": "
        "{},\n  \"models\": [{}\n  ]\n}}\n",
        json_number(analysis.budget.mean), json_number(analysis.budget.p99), json_number(analysis.dispersed_share),
        json_text(to_text(analysis.models[analysis.chosen].model)), json_text(reasons(analysis)), models);
}

}  // namespace

AnalyzeCommand::AnalyzeCommand(CLI::App& program)
    : command_(program.add_subcommand("analyze", "Say what each transport model would get wrong in a scene")),
      options_(std::make_unique<Options>()) {
    Options& options = *options_;
    command_->add_option("SCENE", options.scene, "Scene file in pbrt-v4 syntax")->required()->option_text(" ");
    command_
        ->add_option_function<std::string>(
            "--budget", [&options](const std::string& text) { options.budget = parse_budget(text); },
            fmt::format("Colour error that is good enough, CIEDE2000: mean over pixels, 99th percentile [default: "
                        "{:g},{:g}]",
                        options.budget.mean, options.budget.p99))
        ->option_text("MEAN[,P99]");
    command_->add_flag("--json", options.json, "One JSON object [default: a table for people]");
    add_threads_option(*command_, options.threads);
}

AnalyzeCommand::~AnalyzeCommand() = default;

bool AnalyzeCommand::chosen() const { return command_->parsed(); }

int AnalyzeCommand::run() const {
    Scene scene = read_scene(options_->scene);
    for (const std::string& warning : scene.warnings) print_warning(warning);
    PreparedScene prepared(std::move(scene), options_->threads);
    const ModelAnalysis analysis = analyse_models(prepared, options_->budget, {.threads = options_->threads});
    print_output(options_->json ? json_of(analysis) : text_of(analysis));
    return kDone;
}

}  // namespace emulsion::cli
