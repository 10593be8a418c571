#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace emulsion::cli {

/// `emulsion chart`: what approximations cost and lose, measured now and drawn.
class ChartCommand {
  public:
    /// Adds the subcommand to the program. Its options are read into this object, which must outlive the parsing.
    explicit ChartCommand(CLI::App& program);
    ~ChartCommand();
    ChartCommand(const ChartCommand&) = delete;
    ChartCommand& operator=(const ChartCommand&) = delete;

    [[nodiscard]] bool chosen() const;

    /// \returns the exit code.
    /// \throws IoError and others that say what went wrong.
    [[nodiscard]] int run() const;

  private:
    struct Options;
    CLI::App* command_;
    std::unique_ptr<Options> options_;
};

}  // namespace emulsion::cli
