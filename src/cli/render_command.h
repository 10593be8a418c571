#pragma once

#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace emulsion::cli {

/// `emulsion render`: a scene to EXR and PNG.
class RenderCommand {
  public:
    /// Adds the subcommand to the program. Its options are read into this object, which must outlive the parsing.
    explicit RenderCommand(CLI::App& program);
    ~RenderCommand();
    RenderCommand(const RenderCommand&) = delete;
    RenderCommand& operator=(const RenderCommand&) = delete;

    [[nodiscard]] bool chosen() const;

    /// \returns the exit code.
    /// \throws SceneError, IoError and others that say what went wrong.
    /// \param command_line the whole command, for the header of the file
    [[nodiscard]] int run(const std::string& command_line) const;

  private:
    struct Options;
    CLI::App* command_;
    std::unique_ptr<Options> options_;
};

}  // namespace emulsion::cli
