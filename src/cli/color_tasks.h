#pragma once
// The tasks of `emulsion color`, one a file: each adds its subcommand and gives back what is to be done when it is
// chosen. Results go to standard output, with 17 digits.

#include <functional>

namespace CLI {
class App;
}

namespace emulsion::cli {

struct ColorTask {
    CLI::App* command = nullptr;
    std::function<void()> run;  ///< \throws std::exception saying what went wrong
};

[[nodiscard]] ColorTask add_color_convert(CLI::App& color);
[[nodiscard]] ColorTask add_color_spectrum(CLI::App& color);
[[nodiscard]] ColorTask add_color_difference(CLI::App& color);
[[nodiscard]] ColorTask add_color_adapt(CLI::App& color);
[[nodiscard]] ColorTask add_color_encode(CLI::App& color);
[[nodiscard]] ColorTask add_color_decode(CLI::App& color);
[[nodiscard]] ColorTask add_color_matrix(CLI::App& color);
[[nodiscard]] ColorTask add_color_list(CLI::App& color);

}  // namespace emulsion::cli
