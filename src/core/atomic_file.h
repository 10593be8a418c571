#pragma once
// Files that appear whole or not at all: written under a temporary name in the same folder, then renamed.

#include <filesystem>
#include <optional>

#include <sys/types.h>

namespace emulsion {

/// A file being written. Write to temporary_path(), then commit(); destroyed uncommitted, it leaves nothing behind and
/// the file of that name, if there was one, as it was. As with a plain open, a symbolic link is followed, and the file
/// that it points to is replaced, or created if it is missing; a file that is replaced keeps its permission bits.
/// Unlike there, its owner becomes who writes it, and other hard links keep the old contents.
class AtomicFile {
  public:
    /// Creates the empty temporary file beside `path`.
    /// \throws IoError if the folder is missing or not writable, or if `path` is a folder, a device or a pipe, or a
    /// file that its permissions protect.
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    [[nodiscard]] const std::filesystem::path& temporary_path() const noexcept { return temporary_path_; }

    /// Forces the data to disk and renames the temporary file to path(). Once only.
    /// \throws IoError if either fails; the temporary file then goes with this object.
    void commit();

  private:
    std::filesystem::path path_, target_path_;
    std::optional<::mode_t> old_permissions_;
    std::filesystem::path temporary_path_;
    bool committed_ = false;
};

/// Finds out whether `path` could be written, and leaves no trace: for saying so before hours of work, not after.
/// \throws IoError as AtomicFile does.
void check_writable(const std::filesystem::path& path);

/// Whether writing one of the two replaces the other. Neither needs to exist; symbolic links, "." and ".." are
/// followed. \throws IoError for a circle of links, and if a folder can't be looked into.
[[nodiscard]] bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace emulsion
