#include "pathtracer/gzip.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>

#include <zlib.h>

#include "core/error.h"

namespace emulsion {

namespace {

/// zlib's state, freed at the end.
class Inflater {
  public:
    Inflater() {
        constexpr int kGzipOnly = 16 + MAX_WBITS;
        if (inflateInit2(&stream, kGzipOnly) != Z_OK) throw std::bad_alloc();
    }
    ~Inflater() { inflateEnd(&stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    z_stream stream{};
};

}  // namespace

std::string inflate_gzip(const std::filesystem::path& path, std::string_view compressed, std::size_t most_bytes) {
    Inflater inflater;
    z_stream& stream = inflater.stream;
    std::string content;
    std::array<char, std::size_t{1} << 16u> chunk{};
    std::size_t taken = 0;
    bool between_members = false;
    while (!between_members || taken < compressed.size()) {
        if (between_members) inflateReset(&stream);
        // zlib counts in 32 bits.
        const std::size_t piece = std::min<std::size_t>(compressed.size() - taken, std::numeric_limits<uInt>::max());
        // zlib doesn't write to its input, whatever its type says.
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast,cppcoreguidelines-pro-type-reinterpret-cast)
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data() + taken));
        stream.avail_in = static_cast<uInt>(piece);
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): zlib's bytes are unsigned
        stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
        stream.avail_out = static_cast<uInt>(chunk.size());
        const int result = inflate(&stream, Z_NO_FLUSH);
        taken += piece - stream.avail_in;
        const std::size_t made = chunk.size() - stream.avail_out;
        if (made > most_bytes - content.size()) {
            throw IoError(path, "holds more than " + std::to_string(most_bytes) + " bytes, compressed by gzip");
        }
        content.append(chunk.data(), made);
        if (result == Z_MEM_ERROR) throw std::bad_alloc();
        if (result == Z_BUF_ERROR) throw IoError(path, "is cut off: its gzip data has no end");
        if (result != Z_OK && result != Z_STREAM_END) throw IoError(path, "is damaged, or no gzip file");
        between_members = result == Z_STREAM_END;
    }
    return content;
}

}  // namespace emulsion
