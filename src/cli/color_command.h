#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace emulsion::cli {

/// `emulsion color`: colorimetry on rows of numbers and on spectra; one subcommand of its own for each task.
class ColorCommand {
  public:
    /// Adds the subcommands to the program. Options are read into this object, which must outlive the parsing.
    explicit ColorCommand(CLI::App& program);
    ~ColorCommand();
    ColorCommand(const ColorCommand&) = delete;
    ColorCommand& operator=(const ColorCommand&) = delete;

    [[nodiscard]] bool chosen() const;

    /// \returns the exit code.
    /// \throws IoError and others that say what went wrong.
    [[nodiscard]] int run() const;

  private:
    struct Tasks;
    CLI::App* command_;
    std::unique_ptr<Tasks> tasks_;
};

}  // namespace emulsion::cli
