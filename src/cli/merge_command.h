#pragma once

#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace emulsion::cli {

/// `emulsion merge`: film states that were rendered apart to one.
class MergeCommand {
  public:
    /// Adds the subcommand to the program. Its options are read into this object, which must outlive the parsing.
    explicit MergeCommand(CLI::App& program);
    ~MergeCommand();
    MergeCommand(const MergeCommand&) = delete;
    MergeCommand& operator=(const MergeCommand&) = delete;

    [[nodiscard]] bool chosen() const;

    /// \param command_line what was typed, for the header of the file
    /// \returns the exit code.
    /// \throws IoError and others that say what went wrong.
    [[nodiscard]] int run(const std::string& command_line) const;

  private:
    struct Options;
    CLI::App* command_;
    std::unique_ptr<Options> options_;
};

}  // namespace emulsion::cli
