#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace emulsion::cli {

/// `emulsion compare`: how far two pictures are apart.
class CompareCommand {
  public:
    /// Adds the subcommand to the program. Its options are read into this object, which must outlive the parsing.
    explicit CompareCommand(CLI::App& program);
    ~CompareCommand();
    CompareCommand(const CompareCommand&) = delete;
    CompareCommand& operator=(const CompareCommand&) = delete;

    [[nodiscard]] bool chosen() const;

    /// \returns the exit code: kFailed also if the difference is above what --fail-above allows.
    /// \throws IoError and others that say what went wrong.
    [[nodiscard]] int run() const;

  private:
    struct Options;
    CLI::App* command_;
    std::unique_ptr<Options> options_;
};

}  // namespace emulsion::cli
