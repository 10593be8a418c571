#include "cli/develop_command.h"

#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/distinct_files.h"
#include "cli/messages.h"
#include "cli/option_checks.h"
#include "cli/pipeline_options.h"
#include "core/atomic_file.h"
#include "film/exr_file.h"

namespace emulsion::cli {

struct DevelopCommand::Options {
    std::filesystem::path exr, png;
    int threads = 0;
    bool quiet = false;
    Pipeline pipeline;
};

DevelopCommand::DevelopCommand(CLI::App& program)
    : command_(program.add_subcommand("develop", "Develop a scene-referred EXR to a PNG")),
      options_(std::make_unique<Options>()) {
    Options& options = *options_;
    command_->add_option("EXR", options.exr, "Picture with channels X Y Z or R G B, as `emulsion render` writes it")
        ->required()
        ->option_text(" ");
    command_->add_option("-o,--output", options.png, "8-bit sRGB PNG [required]")
        ->required()
        ->check(ends_in_png)
        ->option_text("FILE");
    add_threads_option(*command_, options.threads);
    command_->add_flag("--quiet", options.quiet, "No summary; warnings and errors only [default: a line]");
    add_pipeline_options(*command_, options.pipeline);
    command_->final_callback([&options] { require_distinct({{"EXR", options.exr}, {"--output", options.png}}); });
}

DevelopCommand::~DevelopCommand() = default;

bool DevelopCommand::chosen() const { return command_->parsed(); }

int DevelopCommand::run() const {
    const Options& options = *options_;
    check_writable(options.png);
    const FilmImage picture = read_exr(options.exr, {.layers = ExrLayers::skip, .threads = options.threads});
    for (const std::string& note : picture.notes) print_warning(options.exr.string() + ": " + note);
    develop_to_png(picture.xyz, options.pipeline, options.threads, options.png);
    if (!options.quiet) print_output(fmt::format("wrote {}\n", options.png.string()));
    return kDone;
}

}  // namespace emulsion::cli
