#include "cli/merge_command.h"

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/distinct_files.h"
#include "cli/exr_output_options.h"
#include "cli/film_files.h"
#include "cli/loss_warnings.h"
#include "cli/messages.h"
#include "cli/option_checks.h"
#include "cli/pipeline_options.h"
#include "cli/samples_text.h"
#include "core/atomic_file.h"
#include "film/film_state.h"

namespace emulsion::cli {

struct MergeCommand::Options {
    std::vector<std::filesystem::path> films;
    std::filesystem::path output, png;
    int threads = 0;
    bool quiet = false;
    ExrOutput exr;
    Pipeline pipeline;
};

namespace {

/// "a, b and c"; of many the first ones, and how many more.
std::string names_of(const std::vector<std::filesystem::path>& films) {
    constexpr std::size_t kNamed = 3;
    std::string names = films.front().string();
    if (films.size() > kNamed) {
        for (std::size_t i = 1; i < kNamed; ++i) names += ", " + films[i].string();
        return names + fmt::format(" and {} more", films.size() - kNamed);
    }
    for (std::size_t i = 1; i < films.size(); ++i) names += (i + 1 < films.size() ? ", " : " and ") + films[i].string();
    return names;
}

/// One after the other, so that never more than two are in memory.
FilmState read_and_merge(const std::vector<std::filesystem::path>& films) {
    FilmState state = read_film_state(films.front());
    for (std::size_t i = 1; i < films.size(); ++i) {
        const FilmState other = read_film_state(films[i]);
        try {
            merge(state, other);
        } catch (const std::invalid_argument& error) {
            const std::vector<std::filesystem::path> before(films.begin(),
                                                            films.begin() + static_cast<std::ptrdiff_t>(i));
            throw std::runtime_error(
                fmt::format("{} does not go with {}: {}", films[i].string(), names_of(before), error.what()));
        }
    }
    return state;
}

}  // namespace

MergeCommand::MergeCommand(CLI::App& program)
    : command_(program.add_subcommand("merge", "Add up film states that were rendered apart")),
      options_(std::make_unique<Options>()) {
    Options& options = *options_;
    command_
        ->add_option("FILM", options.films,
                     "Film states (*.film.exr) of one scene, with different samples; in any order. One alone is "
                     "written anew, as a picture or with other options")
        ->required()
        ->option_text("...");
    command_
        ->add_option("-o,--output", options.output,
                     "NAME.film.exr: a film state again; other names ending in .exr: the picture and its layers alone "
                     "[required]")
        ->required()
        ->check(ends_in_exr)
        ->option_text("FILE");
    command_
        ->add_option("--png", options.png,
                     "Also develop the picture to this PNG, 8-bit sRGB but for what --pipeline says [default: none]")
        ->check(ends_in_png)
        ->option_text("FILE");
    add_exr_options(*command_, options.exr);
    add_threads_option(*command_, options.threads);
    command_->add_flag("--quiet", options.quiet, "No summary; warnings and errors only [default: a few lines]");
    add_pipeline_options(*command_, options.pipeline);
    command_->final_callback([&options] {
        std::vector<NamedFile> files;
        for (const std::filesystem::path& film : options.films) files.push_back({"FILM", film});
        files.push_back({"--output", options.output});
        files.push_back({"--png", options.png});
        require_distinct(files);
        if (!options.png.empty()) check_for_png(options.pipeline);
    });
}

MergeCommand::~MergeCommand() = default;

bool MergeCommand::chosen() const { return command_->parsed(); }

int MergeCommand::run(const std::string& command_line) const {
    const Options& options = *options_;
    check_writable(options.output);
    if (!options.png.empty()) check_writable(options.png);

    FilmState state = read_and_merge(options.films);
    state.metadata.command_line = command_line;
    warn_of_losses(state.contents);
    const ExrOptions exr = exr_options(options.exr, PixelType::float32, options.threads);
    const Image<XYZ> picture = write_film(options.output, state, exr, auto_pixels(options.exr, options.quiet));
    if (!options.png.empty()) {
        const DevelopResult developed = develop_to_png(picture, options.pipeline, options.threads, options.png);
        if (!options.quiet) report_gamut(developed, options.pipeline);
    }
    if (options.quiet) return kDone;
    print_output(fmt::format("{} film{}, {}x{} pixels, {}: {} of each pixel\nwrote {}\n", options.films.size(),
                             options.films.size() == 1 ? "" : "s", picture.width(), picture.height(),
                             samples_text(state.provenance), count_text(state.provenance, state.contents),
                             options.output.string()));
    if (!options.png.empty()) print_output(fmt::format("wrote {}\n", options.png.string()));
    return kDone;
}

}  // namespace emulsion::cli
