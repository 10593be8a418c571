#include "run_program.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace emulsion::testing {

namespace {

[[noreturn]] void become_program(const std::vector<std::string>& arguments) {
    std::vector<std::string> words{EMULSION_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    ::execv(argv[0], argv.data());
    ::_exit(127);
}

void hear_stop_signals() {
    for (const int signal : {SIGINT, SIGTERM}) ::signal(signal, SIG_DFL);
}

std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 4096> buffer{};
    for (;;) {
        const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;  // a terminal ends with EIO
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    ::close(descriptor);
    return text;
}

int exit_code_of(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& arguments, const RunOptions& options) {
    std::array<int, 2> out{}, err{};
    if (::pipe2(out.data(), O_CLOEXEC) != 0 || ::pipe2(err.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe");
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("fork");
    if (child == 0) {
        if (options.signals == StopSignals::heard) hear_stop_signals();
        ::dup2(out[1], STDOUT_FILENO);
        ::dup2(err[1], STDERR_FILENO);
        if (options.before) options.before();
        become_program(arguments);
    }
    ::close(out[1]);
    ::close(err[1]);
    ProgramResult result;
    std::thread err_reader([&] { result.err = read_all(err[0]); });
    std::thread out_reader([&] { result.out = read_all(out[0]); });
    if (options.while_running) options.while_running(child);
    out_reader.join();
    err_reader.join();
    result.exit_code = exit_code_of(child);
    return result;
}

ProgramResult run_program_on_terminal(const std::vector<std::string>& arguments) {
    int terminal = -1;
    const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child < 0) throw std::runtime_error("forkpty");
    if (child == 0) become_program(arguments);
    ProgramResult result;
    result.err = read_all(terminal);
    result.exit_code = exit_code_of(child);
    return result;
}

}  // namespace emulsion::testing
