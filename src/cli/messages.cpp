#include "cli/messages.h"

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "core/error.h"

namespace emulsion::cli {

namespace {

void print_line(std::string_view kind, std::string_view message) {
    std::string line(message);
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    print_progress(fmt::format("emulsion: {}: {}\n", kind, line));
}

}  // namespace

void print_error(std::string_view message) { print_line("error", message); }
void print_warning(std::string_view message) { print_line("warning", message); }

void print_progress(std::string_view text) {
    // Not fmt::print(), which throws when a write fails.
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

void print_output(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

void flush_output() {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    // The failure may lie back too far for its reason to be known.
    throw std::runtime_error("standard output was lost" + (errno != 0 ? ": " + errno_text(errno) : ""));
}

}  // namespace emulsion::cli
