#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace emulsion::cli {

/// `emulsion analyze`: what each transport model would get wrong in a scene, and what it costs.
class AnalyzeCommand {
  public:
    /// Adds the subcommand to the program. Its options are read into this object, which must outlive the parsing.
    explicit AnalyzeCommand(CLI::App& program);
    ~AnalyzeCommand();
    AnalyzeCommand(const AnalyzeCommand&) = delete;
    AnalyzeCommand& operator=(const AnalyzeCommand&) = delete;

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
