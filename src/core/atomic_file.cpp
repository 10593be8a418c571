#include "core/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "core/error.h"

namespace emulsion {

namespace {

std::string reason_of_errno() { return std::generic_category().message(errno); }

/// Creates a new, empty file whose name no other process or thread has, and returns its path.
std::filesystem::path create_beside(const std::filesystem::path& path) {
    if (!path.has_filename()) throw IoError(path, "not a file name");
    if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) throw IoError(path, "is a folder");
    static std::atomic<unsigned> counter{0};
    for (;;) {
        const std::string name = "." + path.filename().string() + "." + std::to_string(::getpid()) + "." +
                                 std::to_string(counter++) + ".tmp";
        std::filesystem::path candidate = path.parent_path() / name;
        const int descriptor = ::open(candidate.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (descriptor >= 0) {
            ::close(descriptor);
            return candidate;
        }
        if (errno != EEXIST) throw IoError(path, "cannot create a file in its folder: " + reason_of_errno());
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

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), temporary_path_(create_beside(path_)) {}

AtomicFile::~AtomicFile() {
    if (!committed_) ::unlink(temporary_path_.c_str());
}

void AtomicFile::commit() {
    sync_to_disk(temporary_path_, path_);
    if (::rename(temporary_path_.c_str(), path_.c_str()) != 0) {
        throw IoError(path_, "cannot rename the temporary file: " + reason_of_errno());
    }
    committed_ = true;
}

void check_writable(const std::filesystem::path& path) { const AtomicFile probe(path); }

}  // namespace emulsion
