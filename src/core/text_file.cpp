#include "core/text_file.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <system_error>

#include "core/atomic_file.h"
#include "core/error.h"

namespace emulsion {

std::string read_text_file(const std::filesystem::path& path) {
    using std::filesystem::file_type;
    std::error_code error;
    const file_type type = std::filesystem::status(path, error).type();
    if (type == file_type::not_found) throw IoError(path, errno_text(ENOENT));
    if (type == file_type::directory) throw IoError(path, "is a folder, not a text file");
    if (type != file_type::regular && type != file_type::fifo) throw IoError(path, "is no file that can be read");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw IoError(path, "can't be opened for reading");

    // read() notes failures of the device in the stream's state; iterators over its buffer don't.
    std::string content;
    std::array<char, std::size_t{1} << 16u> chunk{};
    while (file) {
        file.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
        content.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) throw IoError(path, "reading failed");
    return content;
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
    AtomicFile file(path);
    std::ofstream stream(file.temporary_path(), std::ios::binary | std::ios::trunc);
    stream << text;
    stream.close();
    if (!stream) throw IoError(path, "cannot write: " + errno_text(errno));
    file.commit();
}

}  // namespace emulsion
