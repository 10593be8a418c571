#include "cli/info_command.h"

#include <filesystem>

#include <CLI/CLI.hpp>

#include "cli/film_info.h"
#include "cli/messages.h"
#include "cli/option_checks.h"

namespace emulsion::cli {

struct InfoCommand::Options {
    std::filesystem::path exr;
    int threads = 0;
    bool json = false;
};

InfoCommand::InfoCommand(CLI::App& program)
    : command_(program.add_subcommand("info", "Say what an EXR is, and what is in it")),
      options_(std::make_unique<Options>()) {
    Options& options = *options_;
    command_->add_option("EXR", options.exr, "Film state, film picture, or any other flat EXR")
        ->required()
        ->option_text(" ");
    command_->add_flag("--json", options.json, "One JSON object [default: lines for people]");
    add_threads_option(*command_, options.threads);
}

InfoCommand::~InfoCommand() = default;

bool InfoCommand::chosen() const { return command_->parsed(); }

int InfoCommand::run() const {
    const InfoReport report = report_of(read_film_info(options_->exr, options_->threads));
    print_output(options_->json ? report.json() : report.text());
    return kDone;
}

}  // namespace emulsion::cli
