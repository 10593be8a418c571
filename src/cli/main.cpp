// The `emulsion` program: picks the subcommand, and turns what goes wrong into one line and an exit code.

#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include <CLI/CLI.hpp>
#include <fcntl.h>

#include "cli/analyze_command.h"
#include "cli/chart_command.h"
#include "cli/color_command.h"
#include "cli/compare_command.h"
#include "cli/develop_command.h"
#include "cli/help_formatter.h"
#include "cli/info_command.h"
#include "cli/merge_command.h"
#include "cli/messages.h"
#include "cli/render_command.h"
#include "cli/usage_errors.h"

namespace {

using emulsion::cli::AnalyzeCommand, emulsion::cli::ChartCommand, emulsion::cli::ColorCommand,
    emulsion::cli::CompareCommand;
using emulsion::cli::DevelopCommand;
using emulsion::cli::flush_output, emulsion::cli::print_error;
using emulsion::cli::InfoCommand, emulsion::cli::MergeCommand, emulsion::cli::RenderCommand;
using emulsion::cli::kBadUsage, emulsion::cli::kDone, emulsion::cli::kFailed;
using emulsion::cli::usage_error_text;

/// The command as it could be typed again: words with anything special in them in single quotes.
std::string command_line_text(int argc, char** argv) {
    std::string text;
    for (int i = 0; i < argc; ++i) {
        const std::string word = argv[i];
        const bool plain = !word.empty() && word.find_first_not_of(
                                                "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                "0123456789_-./:=,+@%") == std::string::npos;
        if (i > 0) text += ' ';
        if (plain) {
            text += word;
            continue;
        }
        text += '\'';
        for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
        text += '\'';
    }
    return text;
}

/// A standard stream that was closed when the program started gives its number to the next file that is opened, and
/// words would end up in that file. /dev/null takes the number instead; opened the wrong way round, so that reading and
/// writing fail as before.
void hold_standard_streams() {
    for (int i = 0; i < 3; ++i) {
        if (::fcntl(i, F_GETFD) < 0) ::open("/dev/null", i == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

int run(int argc, char** argv) {
    CLI::App program(
        "Emulsion: film and imaging for physically based renderers.\n"
        "Exit codes: 0 done, 1 failed, 2 bad usage.");
    program.name("emulsion");
    program.set_version_flag("--version", "emulsion " EMULSION_VERSION);
    program.require_subcommand(1);
    // Of flags: --half, not --half=yes. Subcommands inherit it.
    program.option_defaults()->disable_flag_override();
    program.formatter(emulsion::cli::help_formatter());
    const RenderCommand render(program);
    const DevelopCommand develop(program);
    const MergeCommand merge(program);
    const InfoCommand info(program);
    const CompareCommand compare(program);
    const AnalyzeCommand analyze(program);
    const ChartCommand chart(program);
    const ColorCommand color(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return program.exit(success);  // --help, --version
    } catch (const CLI::ParseError& error) {
        print_error(usage_error_text(program, error));
        return kBadUsage;
    }
    if (analyze.chosen()) return analyze.run();
    if (chart.chosen()) return chart.run();
    if (color.chosen()) return color.run();
    if (compare.chosen()) return compare.run();
    if (info.chosen()) return info.run();
    if (merge.chosen()) return merge.run(command_line_text(argc, argv));
    return render.chosen() ? render.run(command_line_text(argc, argv)) : develop.run();
}

}  // namespace

int main(int argc, char** argv) {
    // A file that may not grow further, or a pipe that nobody reads, is then an error like any other, not the end of
    // the process.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    hold_standard_streams();
    try {
        const int exit_code = run(argc, argv);
        if (exit_code == kDone) flush_output();
        return exit_code;
    } catch (const CLI::ParseError& error) {
        // Found only when the scene was read: two names for one file.
        print_error(error.what());
        return kBadUsage;
    } catch (const std::bad_alloc&) {
        print_error("out of memory");
    } catch (const std::exception& error) {
        print_error(error.what());
    } catch (...) {
        print_error("unknown failure");
    }
    return kFailed;
}
