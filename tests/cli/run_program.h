#pragma once
// Runs the `emulsion` program as a user's shell would, and gives back what it said.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace emulsion::testing {

struct ProgramResult {
    int exit_code = -1;  ///< -1: ended by a signal
    std::string out, err;
};

/// `before` runs in the child process before the program starts; `while_running` in this one, with the child's id.
struct RunOptions {
    std::function<void()> before = {};
    std::function<void(pid_t)> while_running = {};
};

ProgramResult run_program(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// The same with standard error on a terminal; what it shows there is in `err`.
ProgramResult run_program_on_terminal(const std::vector<std::string>& arguments);

/// A new, empty folder that is removed again.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
    /// Names of all files in it, hidden ones too, in order.
    [[nodiscard]] std::vector<std::string> names() const;

  private:
    std::filesystem::path path_;
};

[[nodiscard]] std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace emulsion::testing
