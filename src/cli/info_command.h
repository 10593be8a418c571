#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace emulsion::cli {

/// `emulsion info`: what an EXR is, and what is in it.
class InfoCommand {
  public:
    /// Adds the subcommand to the program. Its options are read into this object, which must outlive the parsing.
    explicit InfoCommand(CLI::App& program);
    ~InfoCommand();
    InfoCommand(const InfoCommand&) = delete;
    InfoCommand& operator=(const InfoCommand&) = delete;

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
