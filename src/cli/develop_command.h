#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace emulsion::cli {

/// `emulsion develop`: an EXR to PNG.
class DevelopCommand {
  public:
    /// Adds the subcommand to the program. Its options are read into this object, which must outlive the parsing.
    explicit DevelopCommand(CLI::App& program);
    ~DevelopCommand();
    DevelopCommand(const DevelopCommand&) = delete;
    DevelopCommand& operator=(const DevelopCommand&) = delete;

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
