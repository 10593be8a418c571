#pragma once
// Files that appear whole or not at all: written without a name, or under a hidden one, and named when they are whole.

#include <filesystem>
#include <optional>

#include <sys/types.h>

#include "core/temporary_file.h"

namespace emulsion {

/// A file being written. Write to temporary_path(), then commit(); destroyed uncommitted, it leaves nothing behind and
/// the file of that name, if there was one, as it was. As with a plain open, a symbolic link is followed, and the file
/// that it points to is replaced, or created if it is missing; a file that is replaced keeps its permission bits.
/// Unlike there, its owner becomes who writes it, and other hard links keep the old contents.
///
/// A process that is killed leaves nothing behind either, where the file system has files without a name (O_TMPFILE:
/// ext4, XFS, Btrfs, tmpfs; not NFS). TemporaryFile tells of the one moment in which it would.
class AtomicFile {
  public:
    /// Creates the empty temporary file in the folder of `path`.
    /// \throws IoError if the folder is missing or not writable, or if `path` is a folder, a device or a pipe, or a
    /// file that its permissions protect.
    explicit AtomicFile(std::filesystem::path path, TemporaryName name = TemporaryName::none);

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    /// What this process opens to write the contents; it is there already, and need not be a name in the folder.
    [[nodiscard]] const std::filesystem::path& temporary_path() const noexcept { return temporary_.path(); }

    /// Forces the data to disk and gives the temporary file the name path(). Once only.
    /// \throws IoError if either fails; the temporary file then goes with this object.
    void commit();

  private:
    std::filesystem::path path_, target_path_;
    std::optional<::mode_t> old_permissions_;
    TemporaryFile temporary_;
};

/// Finds out whether `path` could be written, and leaves no trace: for saying so before hours of work, not after.
/// \throws IoError as AtomicFile does.
void check_writable(const std::filesystem::path& path);

/// Whether writing one of the two replaces the other. Neither needs to exist; symbolic links, "." and ".." are
/// followed. \throws IoError for a circle of links, and if a folder can't be looked into.
[[nodiscard]] bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace emulsion
