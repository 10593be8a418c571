#pragma once
// A file that is there for its writer only, until it is given its name.

#include <filesystem>

#include <sys/types.h>

namespace emulsion {

/// Whether a file that is being written has a name meanwhile.
enum class TemporaryName {
    none,   ///< none, so that it is gone even if its process is killed; hidden where the file system can't do that
    hidden  ///< ".NAME.film.exr.PID.N.tmp", in the folder of the file that it is to become
};

/// A new, empty file beside `target`, which is gone with this object, or with the process, unless rename_to() gave it a
/// name. One with a hidden name stays behind when its process is killed.
class TemporaryFile {
  public:
    /// \param permissions as of open(): what the process's mask leaves of them
    /// \param named what errors name
    /// \throws IoError if the folder is missing or not writable.
    TemporaryFile(std::filesystem::path target, ::mode_t permissions, TemporaryName name,
                  const std::filesystem::path& named);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// To open it by, in this process: a name in its folder, or "/proc/self/fd/N" for a file without one.
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

    /// Makes it the file `target`, in the place of one that may be there; once only. The name stands for the old file
    /// or for this one at every moment. Over an old file, one without a name is linked to a hidden name and renamed:
    /// killed between the two, the process leaves that name, of a whole file, behind. \returns 0, or what failed as an
    /// errno; it is then gone with this object.
    [[nodiscard]] int rename_to(const std::filesystem::path& target);

  private:
    bool create_without_name(::mode_t permissions);
    void create_hidden(::mode_t permissions, const std::filesystem::path& named);
    /// What no other process or thread asks for.
    [[nodiscard]] std::filesystem::path new_hidden_name() const;

    std::filesystem::path target_, path_;
    std::filesystem::path hidden_name_;  // empty if it has none
    int descriptor_ = -1;
};

}  // namespace emulsion
