#pragma once
// libpng's structures, and what it says of errors.
//
// libpng reports an error by a callback that must not return. An exception must not pass through its C frames, so the
// callback jumps back to the caller's setjmp(png_jmpbuf(handle.png())), whose frame holds nothing that would need a
// destructor. Everything that does need one lives in the caller's caller.

#include <array>

#include <png.h>

namespace emulsion {

/// What libpng said, as far as it fits; empty: nothing.
struct PngMessage {
    std::array<char, 256> text{};
};

/// What a handle is for. Writing, a warning is an error: something that was asked for is not in the file. What it warns
/// of in reading it has repaired or left out: damaged chunks that are not of the picture.
enum class PngTask { read, write };

/// The two structures of a file that is read or written.
class PngHandle {
  public:
    /// \param message gets the first error, or warning; it must outlive the handle.
    PngHandle(PngTask task, PngMessage& message);
    ~PngHandle();
    PngHandle(const PngHandle&) = delete;
    PngHandle& operator=(const PngHandle&) = delete;

    /// False if there was no memory for them; then nothing may be done with them.
    [[nodiscard]] bool created() const noexcept { return info_ != nullptr; }
    [[nodiscard]] png_structp png() const noexcept { return png_; }
    [[nodiscard]] png_infop info() const noexcept { return info_; }

  private:
    PngTask task_;
    png_structp png_;
    png_infop info_;
};

}  // namespace emulsion
