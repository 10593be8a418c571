#include "core/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "core/error.h"

namespace emulsion {

namespace {

std::string reason_of_errno() { return std::generic_category().message(errno); }

/// The file that will be replaced: `path`, or what it points to if it is a symbolic link.
/// \throws IoError if what is there can't be, or may not be, replaced by a file.
std::filesystem::path replaceable_target(const std::filesystem::path& path) {
    if (!path.has_filename()) throw IoError(path, "not a file name");
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) return path;
    if (!std::filesystem::status_known(status)) throw IoError(path, "cannot be looked up: " + error.message());
    if (std::filesystem::is_directory(status)) throw IoError(path, "is a folder");
    // A rename would put a plain file in the place of /dev/null.
    if (!std::filesystem::is_regular_file(status)) throw IoError(path, "is a device or a pipe, expected a file");
    // A rename asks only the folder; a file that is itself protected shall stay.
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        throw IoError(path, "cannot be replaced: " + reason_of_errno());
    std::filesystem::path target = std::filesystem::canonical(path, error);
    if (error) throw IoError(path, "cannot be looked up: " + error.message());
    return target;
}

/// Creates a new, empty file beside `target`, with a name that no other process or thread has, and returns its path.
std::filesystem::path create_beside(const std::filesystem::path& target, const std::filesystem::path& named) {
    static std::atomic<unsigned> counter{0};
    // The temporary name must fit where the name itself does.
    constexpr std::size_t kKeptOfName = 64;
    const std::string stem = "." + target.filename().string().substr(0, kKeptOfName) + ".";
    for (;;) {
        const std::string unique = std::to_string(::getpid()) + "." + std::to_string(counter++);
        std::filesystem::path candidate = target.parent_path() / (stem + unique + ".tmp");
        const int descriptor = ::open(candidate.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (descriptor >= 0) {
            ::close(descriptor);
            return candidate;
        }
        if (errno != EEXIST) throw IoError(named, "cannot create a file in its folder: " + reason_of_errno());
    }
}

void sync_to_disk(const std::filesystem::path& file, const std::filesystem::path& named) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) throw IoError(named, "cannot reopen the temporary file: " + reason_of_errno());
    const bool synced = ::fsync(descriptor) == 0;
    const std::string reason = synced ? "" : reason_of_errno();
    ::close(descriptor);
    if (!synced) throw IoError(named, "cannot write to disk: " + reason);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)),
      target_path_(replaceable_target(path_)),
      temporary_path_(create_beside(target_path_, path_)) {}

AtomicFile::~AtomicFile() {
    if (!committed_) ::unlink(temporary_path_.c_str());
}

void AtomicFile::commit() {
    sync_to_disk(temporary_path_, path_);
    if (::rename(temporary_path_.c_str(), target_path_.c_str()) != 0) {
        throw IoError(path_, "cannot rename the temporary file: " + reason_of_errno());
    }
    committed_ = true;
}

void check_writable(const std::filesystem::path& path) { const AtomicFile probe(path); }

}  // namespace emulsion
