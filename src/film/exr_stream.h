#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <OpenEXR/ImfIO.h>

namespace emulsion {

/// A stream for OpenEXR that knows for certain whether every byte was written. OpenEXR's own closes without a look, and
/// its OutputFile writes the table of chunks in a destructor that swallows errors; so the first error is kept here, and
/// finish() throws it.
class CheckedOStream : public Imf::OStream {
  public:
    /// Opens `file`, which must exist. Errors name `named`. \throws IoError if it cannot be opened.
    CheckedOStream(const std::filesystem::path& file, std::filesystem::path named);
    ~CheckedOStream() override;
    CheckedOStream(const CheckedOStream&) = delete;
    CheckedOStream& operator=(const CheckedOStream&) = delete;

    void write(const char* bytes, int count) override;
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override;

    /// To be called when all is written. \throws IoError if anything went wrong, even if nobody listened then.
    void finish();

  private:
    [[noreturn]] void fail(int error);
    void flush();
    void write_all(const char* bytes, std::size_t count);

    std::filesystem::path named_;
    int descriptor_;
    int error_ = 0;
    std::vector<char> buffer_;
    std::uint64_t position_ = 0;
};

}  // namespace emulsion
