#include "core/atomic_file.h"

#include <cerrno>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace emulsion {

namespace {

constexpr ::mode_t kPermissionBits = 0777;  // a plain write would clear the others, as set-user-id

/// `path`, or what it points to if it is a symbolic link, whether that is there or not.
std::filesystem::path link_target(std::filesystem::path path) {
    constexpr int kMaxLinks = 40;  // as Linux
    const std::filesystem::path named = path;
    std::error_code error;
    for (int links = 0; std::filesystem::is_symlink(std::filesystem::symlink_status(path, error)); ++links) {
        if (links == kMaxLinks) throw IoError(named, "cannot be looked up: " + errno_text(ELOOP));
        // A relative link starts from its own folder; an absolute one replaces it.
        path = path.parent_path() / std::filesystem::read_symlink(path, error);
        if (error) throw IoError(named, "cannot be looked up: " + error.message());
    }
    return path;
}

/// The file that will be replaced, or created: `path`, or what it points to.
/// \throws IoError if what is there can't be, or may not be, replaced by a file.
std::filesystem::path replaceable_target(const std::filesystem::path& path) {
    if (!path.has_filename()) throw IoError(path, "not a file name");
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) {
        std::filesystem::path target = link_target(path);
        if (!target.has_filename()) throw IoError(path, "points to a folder");
        return target;
    }
    if (!std::filesystem::status_known(status)) throw IoError(path, "cannot be looked up: " + error.message());
    if (std::filesystem::is_directory(status)) throw IoError(path, "is a folder");
    // A rename would put a plain file in the place of /dev/null.
    if (!std::filesystem::is_regular_file(status)) throw IoError(path, "is a device or a pipe, expected a file");
    // A rename asks only the folder; a file that is itself protected shall stay.
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        throw IoError(path, "cannot be replaced: " + errno_text(errno));
    std::filesystem::path target = std::filesystem::canonical(path, error);
    if (error) throw IoError(path, "cannot be looked up: " + error.message());
    return target;
}

/// Those of the file that will be replaced; none if there is no such file.
std::optional<::mode_t> permissions_of(const std::filesystem::path& target) {
    struct stat status {};
    if (::stat(target.c_str(), &status) != 0) return std::nullopt;
    return status.st_mode & kPermissionBits;
}

/// Gives the file its permissions, if any are asked for, and forces it to disk. 0, or what failed as an errno.
int finish_file(int descriptor, const std::optional<::mode_t>& permissions) {
    if (permissions) {
        struct stat status {};
        if (::fstat(descriptor, &status) != 0) return errno;
        // Asked only where needed: some file systems have one set of permissions for all files, and refuse.
        const bool as_asked = (status.st_mode & kPermissionBits) == *permissions;
        if (!as_asked && ::fchmod(descriptor, *permissions) != 0) return errno;
    }
    return ::fsync(descriptor) == 0 ? 0 : errno;
}

}  // namespace

// Until it is whole, nobody else may read what replaces a file that others perhaps may not read.
AtomicFile::AtomicFile(std::filesystem::path path, TemporaryName name)
    : path_(std::move(path)),
      target_path_(replaceable_target(path_)),
      old_permissions_(permissions_of(target_path_)),
      temporary_(target_path_, old_permissions_ ? 0600 : 0666, name, path_) {}

void AtomicFile::commit() {
    if (const int error = finish_file(temporary_.descriptor(), old_permissions_); error != 0) {
        throw IoError(path_, "cannot write to disk: " + errno_text(error));
    }
    if (const int error = temporary_.rename_to(target_path_); error != 0) {
        throw IoError(path_, "cannot rename the temporary file: " + errno_text(error));
    }
}

void check_writable(const std::filesystem::path& path) { const AtomicFile probe(path); }

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto place = [](const std::filesystem::path& path) {
        std::error_code error;
        std::filesystem::path found = std::filesystem::absolute(link_target(path), error);
        if (!error) found = std::filesystem::weakly_canonical(found, error);
        if (error) throw IoError(path, "cannot be looked up: " + error.message());
        return found;
    };
    return place(a) == place(b);
}

}  // namespace emulsion
