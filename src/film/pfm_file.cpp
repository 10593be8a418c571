#include "film/pfm_file.h"

#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/text_file.h"
#include "film/rgb_input.h"
#include "film/scene_rgb.h"

namespace emulsion {

namespace {

void put_float(float value, std::string& bytes) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (const unsigned shift : {0u, 8u, 16u, 24u}) bytes += static_cast<char>(bits >> shift & 0xffu);
}

enum class ByteOrder { little_endian, big_endian };

/// Four bytes from `at` on.
float float_at(std::string_view bytes, std::size_t at, ByteOrder order) noexcept {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t from_top = order == ByteOrder::little_endian ? 3 - i : i;
        bits = bits << 8u | static_cast<unsigned char>(bytes[at + from_top]);
    }
    return std::bit_cast<float>(bits);
}

bool is_space(char c) noexcept { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// The words of the header, each ended by white space.
class HeaderReader {
  public:
    HeaderReader(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

    /// The next word, which `what` names in errors. Afterwards one white space was read behind it.
    std::string_view word(const std::string& what) {
        while (at_ < bytes_.size() && is_space(bytes_[at_])) ++at_;
        const std::size_t begin = at_;
        while (at_ < bytes_.size() && !is_space(bytes_[at_])) {
            if (++at_ - begin > kLongestWord) fail(begin, what, "more than 40 characters without a space");
        }
        if (at_ == bytes_.size()) fail(begin, what, "the end of the file");
        return bytes_.substr(begin, at_++ - begin);
    }
    template <class Number>
    Number number(const std::string& what, Number least, Number most) {
        const std::string_view text = word(what);
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = error == std::errc{} && end == text.data() + text.size();
        if (!whole || !(value >= least && value <= most)) {
            fail(at_ - 1 - text.size(), what, '"' + std::string(text) + '"');
        }
        return value;
    }
    [[noreturn]] void fail(std::size_t place, const std::string& what, const std::string& found) const {
        throw IoError(path_, "PFM header, byte " + std::to_string(place) + ": found " + found + ", expected " + what);
    }
    [[nodiscard]] std::size_t at() const noexcept { return at_; }

  private:
    static constexpr std::size_t kLongestWord = 40;
    const std::filesystem::path& path_;
    std::string_view bytes_;
    std::size_t at_ = 0;
};

struct Header {
    std::size_t channels = 3;
    int width = 0, height = 0;
    float scale = -1.0f;
    std::size_t begin = 0;  ///< of the samples
};

Header read_header(const std::filesystem::path& path, std::string_view bytes) {
    HeaderReader reader(path, bytes);
    Header header;
    const std::string_view magic = reader.word("PF or Pf");
    if (magic != "PF" && magic != "Pf") reader.fail(0, "PF or Pf", '"' + std::string(magic) + '"');
    header.channels = magic == "PF" ? 3 : 1;
    constexpr int kMost = std::numeric_limits<int>::max();
    header.width = reader.number<int>("a width of at least 1", 1, kMost);
    header.height = reader.number<int>("a height of at least 1", 1, kMost);
    constexpr float kLargest = std::numeric_limits<float>::max();
    const std::string scale = "a scale that is not 0: negative for little endian";
    header.scale = reader.number<float>(scale, -kLargest, kLargest);
    header.begin = reader.at();
    if (header.scale == 0.0f) reader.fail(header.begin - 1, scale, "0");
    return header;
}

}  // namespace

void write_pfm(const std::filesystem::path& path, const Image<XYZ>& xyz, const SceneWriteOptions& options) {
    const SceneRgb to_rgb(xyz, options);
    AtomicFile file(path);
    std::ofstream stream(file.temporary_path(), std::ios::binary | std::ios::trunc);
    stream << "PF\n" << xyz.width() << ' ' << xyz.height() << "\n-1.0\n";
    std::string bytes;
    for (int y = xyz.height() - 1; y >= 0; --y) {
        bytes.clear();
        for (const XYZ& pixel : xyz.row(y)) {
            const RGB rgb = to_rgb(pixel);
            for (const float value : {rgb.r, rgb.g, rgb.b}) put_float(value, bytes);
        }
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    stream.close();
    if (!stream) throw IoError(path, "cannot write: " + errno_text(errno));
    file.commit();
}

ScenePicture read_pfm(const std::filesystem::path& path) {
    const std::string bytes = read_text_file(path);
    Header header = read_header(path, bytes);
    const std::size_t pixel_bytes = 4 * header.channels;
    const std::size_t count = static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
    // Lines that end in CR LF: of the two, one was read. A sample may begin with LF: then there is no byte left over.
    if (bytes[header.begin - 1] == '\r' && bytes.size() - header.begin == count * pixel_bytes + 1 &&
        bytes[header.begin] == '\n') {
        ++header.begin;
    }
    const std::size_t there = bytes.size() - header.begin;
    if (there / pixel_bytes < count) {
        throw IoError(path, "PFM of " + std::to_string(header.width) + "x" + std::to_string(header.height) +
                                " pixels: found " + std::to_string(there) + " bytes of samples, expected " +
                                std::to_string(count) + " times " + std::to_string(pixel_bytes));
    }
    ScenePicture picture{Image<XYZ>(header.width, header.height), {kNoPrimariesNote, kNoWhiteLuminanceNote}};
    if (std::abs(header.scale) != 1.0f) {
        picture.notes.push_back("a scale of " + std::to_string(header.scale) + " was not applied");
    }
    if (there != count * pixel_bytes) picture.notes.emplace_back("bytes behind the picture were left out");

    const RgbInput input(rgb_space("Rec709"));
    const ByteOrder order = header.scale < 0.0f ? ByteOrder::little_endian : ByteOrder::big_endian;
    std::size_t at = header.begin;
    for (int y = header.height - 1; y >= 0; --y) {
        for (XYZ& pixel : picture.xyz.row(y)) {
            std::array<float, 3> sample{};
            for (std::size_t c = 0; c < header.channels; ++c) {
                sample[c] = float_at(bytes, at + 4 * c, order);
            }
            if (header.channels == 1) sample[1] = sample[2] = sample[0];
            at += pixel_bytes;
            pixel = input.to_xyz({sample[0], sample[1], sample[2]});
        }
    }
    return picture;
}

}  // namespace emulsion
