#include "cli/messages.h"

#include <cstdio>
#include <string>

#include <fmt/format.h>

namespace emulsion::cli {

namespace {

void print_line(std::string_view kind, std::string_view message) {
    std::string line(message);
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    fmt::print(stderr, "emulsion: {}: {}\n", kind, line);
}

}  // namespace

void print_error(std::string_view message) { print_line("error", message); }
void print_warning(std::string_view message) { print_line("warning", message); }

}  // namespace emulsion::cli
