#pragma once
// Runs the `emulsion` program as a user's shell would, and gives back what it said.

#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace emulsion::testing {

struct ProgramResult {
    int exit_code = -1;  ///< -1: ended by a signal
    std::string out, err;
};

/// Whether the program hears Ctrl-C and the request to terminate, or ignores those that the tests ignore. Shells have
/// what they start in the background ignore Ctrl-C, tests too: a program that one means to interrupt would never end.
enum class StopSignals { heard, inherited };

/// `before` runs in the child process before the program starts; `while_running` in this one, with the child's id.
struct RunOptions {
    StopSignals signals = StopSignals::heard;
    std::function<void()> before = {};
    std::function<void(pid_t)> while_running = {};
};

ProgramResult run_program(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// The same with standard error on a terminal; what it shows there is in `err`.
ProgramResult run_program_on_terminal(const std::vector<std::string>& arguments);

}  // namespace emulsion::testing
