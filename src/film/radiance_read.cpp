#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/text_file.h"
#include "film/radiance_file.h"
#include "film/radiance_header.h"
#include "film/radiance_limits.h"
#include "film/rgb_input.h"
#include "film/rgbe.h"
#include "film/scene_rgb.h"

namespace emulsion {

namespace {

/// The bytes of the scan lines.
class ScanLines {
  public:
    ScanLines(const std::filesystem::path& path, std::string_view bytes, std::size_t begin)
        : path_(path), bytes_(bytes), at_(begin) {}

    void read(std::span<Rgbe> line) {
        ++number_;
        if (is_new_style(line.size())) {
            read_new_style(line);
        } else {
            read_old_style(line);
        }
    }
    [[nodiscard]] bool at_end() const noexcept { return at_ == bytes_.size(); }

  private:
    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw IoError(path_, "Radiance scan line " + std::to_string(number_) + ", byte " + std::to_string(at_) +
                                 " of the file: found " + found + ", expected " + expected);
    }
    std::uint8_t next() {
        if (at_ == bytes_.size()) fail("the end of the file", "more pixels");
        return static_cast<std::uint8_t>(bytes_[at_++]);
    }
    Rgbe next_pixel() {
        Rgbe pixel{};
        for (std::uint8_t& byte : pixel) byte = next();
        return pixel;
    }

    [[nodiscard]] bool is_new_style(std::size_t width) const noexcept {
        return width >= kLeastRunWidth && width <= kMostRunWidth && bytes_.size() - at_ >= 3 && bytes_[at_] == 2 &&
               bytes_[at_ + 1] == 2 && static_cast<unsigned char>(bytes_[at_ + 2]) < 128;
    }

    /// Component by component: a count up to 128 and as many values, or 128 + count and one.
    void read_new_style(std::span<Rgbe> line) {
        const Rgbe start = next_pixel();
        const std::size_t width = std::size_t{start[2]} << 8u | start[3];
        if (width != line.size()) fail(std::to_string(width) + " pixels", std::to_string(line.size()));
        for (std::size_t component = 0; component < 4; ++component) {
            for (std::size_t x = 0; x < line.size();) {
                const std::uint8_t code = next();
                const std::size_t count = code > 128 ? code - 128u : code;
                if (count == 0 || count > line.size() - x) {
                    fail("a run of " + std::to_string(count), "1 to " + std::to_string(line.size() - x));
                }
                std::uint8_t value = next();
                for (std::size_t i = 0; i < count; ++i) {
                    if (i > 0 && code <= 128) value = next();
                    line[x++][component] = value;
                }
            }
        }
    }

    /// Pixels; {1, 1, 1, n} repeats the one before n times, and next to another such n * 256 times, and so on.
    void read_old_style(std::span<Rgbe> line) {
        std::size_t x = 0;
        unsigned shift = 0;
        while (x < line.size()) {
            const Rgbe pixel = next_pixel();
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                line[x++] = pixel;
                shift = 0;
                continue;
            }
            const std::size_t count = shift < 32 ? std::size_t{pixel[3]} << shift : line.size() + 1;
            if (x == 0) fail("a repetition", "a pixel to repeat");
            if (count > line.size() - x) {
                fail("a run of " + std::to_string(count), "at most " + std::to_string(line.size() - x));
            }
            for (std::size_t i = 0; i < count; ++i, ++x) line[x] = line[x - 1];
            shift += 8;
        }
    }

    const std::filesystem::path& path_;
    std::string_view bytes_;
    std::size_t at_;
    int number_ = 0;
};

/// All scan lines, one after another. They grow as they are read: a damaged size takes no memory that no bytes fill.
std::vector<Rgbe> read_lines(ScanLines& lines, const RadianceHeader& header) {
    const auto length = static_cast<std::size_t>(header.rows ? header.width : header.height);
    const int count = header.rows ? header.height : header.width;
    std::vector<Rgbe> pixels;
    for (int i = 0; i < count; ++i) {
        pixels.resize(pixels.size() + length);
        lines.read(std::span(pixels).last(length));
    }
    return pixels;
}

std::vector<std::string> notes_of(const RadianceHeader& header, const ScanLines& lines) {
    std::vector<std::string> notes;
    if (!header.format) notes.emplace_back("no FORMAT: taken as 32-bit_rle_rgbe");
    if (!header.space && header.format != RadianceFormat::xyze) notes.emplace_back(kNoPrimariesNote);
    notes.emplace_back(kNoWhiteLuminanceNote);
    if (!lines.at_end()) notes.emplace_back("bytes behind the picture were left out");
    return notes;
}

}  // namespace

ScenePicture read_radiance(const std::filesystem::path& path) {
    const std::string bytes = read_text_file(path);
    const RadianceHeader header = read_radiance_header(path, bytes);
    ScanLines lines(path, bytes, header.begin);
    const std::vector<Rgbe> pixels = read_lines(lines, header);

    ScenePicture picture{Image<XYZ>(header.width, header.height), notes_of(header, lines)};
    const RgbInput input(header.space.value_or(rgb_space("Rec709")));
    std::array<float, 3> factor{};
    for (std::size_t i = 0; i < 3; ++i) factor[i] = static_cast<float>(1.0 / (header.exposure * header.correction[i]));
    for (int y = 0; y < header.height; ++y) {
        for (int x = 0; x < header.width; ++x) {
            const int line_x = header.forward_x ? x : header.width - 1 - x;
            const int line_y = header.forward_y ? y : header.height - 1 - y;
            const std::size_t at = header.rows
                                       ? static_cast<std::size_t>(line_y) * static_cast<std::size_t>(header.width) +
                                             static_cast<std::size_t>(line_x)
                                       : static_cast<std::size_t>(line_x) * static_cast<std::size_t>(header.height) +
                                             static_cast<std::size_t>(line_y);
            const RGB stored = from_rgbe(pixels[at]);
            const RGB rgb{factor[0] * stored.r, factor[1] * stored.g, factor[2] * stored.b};
            const bool is_xyz = header.format == RadianceFormat::xyze;
            picture.xyz(x, y) = is_xyz ? XYZ{rgb.r, rgb.g, rgb.b} : input.to_xyz(rgb);
        }
    }
    return picture;
}

}  // namespace emulsion
