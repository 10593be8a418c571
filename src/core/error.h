#pragma once
// The two errors that leave the library: std::invalid_argument for a value out of its range, IoError for a file.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace emulsion {

/// A file that can't be read or written, or that holds something else than expected. what() is "path: reason".
class IoError : public std::runtime_error {
  public:
    IoError(std::filesystem::path path, std::string reason)
        : std::runtime_error(path.string() + ": " + reason), path_(std::move(path)), reason_(std::move(reason)) {}

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

  private:
    std::filesystem::path path_;
    std::string reason_;
};

/// What an `errno` says, "No such file or directory": for the reason of an IoError.
[[nodiscard]] inline std::string errno_text(int error_number) { return std::generic_category().message(error_number); }

}  // namespace emulsion
