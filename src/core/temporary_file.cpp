#include "core/temporary_file.h"

#include <atomic>
#include <cerrno>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace emulsion {

namespace {

/// Links the file that `path` opens under a further name. 0, or what failed as an errno.
int link_as(const std::filesystem::path& path, const std::filesystem::path& name) {
    // By the link in /proc, which anybody may follow to what they have opened; AT_EMPTY_PATH is for the superuser.
    return ::linkat(AT_FDCWD, path.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
}

}  // namespace

TemporaryFile::TemporaryFile(std::filesystem::path target, ::mode_t permissions, TemporaryName name,
                             const std::filesystem::path& named)
    : target_(std::move(target)) {
    if (name == TemporaryName::none && create_without_name(permissions)) return;
    create_hidden(permissions, named);
}

TemporaryFile::~TemporaryFile() {
    ::close(descriptor_);
    if (!hidden_name_.empty()) ::unlink(hidden_name_.c_str());
}

int TemporaryFile::rename_to(const std::filesystem::path& target) {
    if (hidden_name_.empty()) {
        // Where there is no file yet, its name is all that it needs; a link replaces none.
        int error = link_as(path_, target);
        if (error != EEXIST) return error;
        do {
            hidden_name_ = new_hidden_name();
            error = link_as(path_, hidden_name_);
        } while (error == EEXIST);
        if (error != 0) {
            hidden_name_.clear();
            return error;
        }
    }
    if (::rename(hidden_name_.c_str(), target.c_str()) != 0) return errno;
    hidden_name_.clear();
    return 0;
}

/// False where that can't be done; whoever falls back to a name finds out what else is wrong.
bool TemporaryFile::create_without_name(::mode_t permissions) {
    const std::filesystem::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
    const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, permissions);
    if (descriptor < 0) return false;
    path_ = "/proc/self/fd/" + std::to_string(descriptor);
    struct stat opened {
    }, found{};
    // Without /proc there is no way to it, nor to a name.
    const bool is_reachable = ::fstat(descriptor, &opened) == 0 && ::stat(path_.c_str(), &found) == 0 &&
                              opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
    if (!is_reachable) {
        ::close(descriptor);
        return false;
    }
    descriptor_ = descriptor;
    return true;
}

void TemporaryFile::create_hidden(::mode_t permissions, const std::filesystem::path& named) {
    do {
        hidden_name_ = new_hidden_name();
        descriptor_ = ::open(hidden_name_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, permissions);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) throw IoError(named, "cannot create a file in its folder: " + errno_text(errno));
    path_ = hidden_name_;
}

std::filesystem::path TemporaryFile::new_hidden_name() const {
    static std::atomic<unsigned> counter{0};
    // It must fit where the target's name does.
    constexpr std::size_t kKeptOfName = 64;
    const std::string stem = "." + target_.filename().string().substr(0, kKeptOfName) + ".";
    const std::string unique = std::to_string(::getpid()) + "." + std::to_string(counter++);
    return target_.parent_path() / (stem + unique + ".tmp");
}

}  // namespace emulsion
