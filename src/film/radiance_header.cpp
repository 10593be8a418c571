#include "film/radiance_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/error.h"

namespace emulsion {

namespace {

constexpr int kMostPixels = 1 << 20;

/// Lines, counted from 1.
class LineReader {
  public:
    LineReader(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

    /// Without its end.
    std::string_view next(const char* expected) {
        constexpr std::size_t kLongest = 65536;
        ++line_;
        const std::size_t end = bytes_.substr(at_, kLongest).find('\n');
        if (end == std::string_view::npos) fail("no end of the line", expected);
        const std::string_view line = bytes_.substr(at_, end);
        at_ += end + 1;
        return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
    }
    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw IoError(path_,
                      "Radiance header, line " + std::to_string(line_) + ": found " + found + ", expected " + expected);
    }
    [[nodiscard]] std::size_t at() const noexcept { return at_; }

  private:
    const std::filesystem::path& path_;
    std::string_view bytes_;
    std::size_t at_ = 0;
    int line_ = 0;
};

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    constexpr std::string_view kSpace = " \t";
    for (std::size_t begin = line.find_first_not_of(kSpace); begin != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(kSpace, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(kSpace, end);
    }
    return words;
}

std::string quoted(std::string_view text) { return '"' + std::string(text.substr(0, 80)) + '"'; }

/// All of `text` as so many numbers.
template <std::size_t Count>
std::array<double, Count> numbers(std::string_view text, const LineReader& lines, const char* expected) {
    const std::vector<std::string_view> words = words_of(text);
    std::array<double, Count> values{};
    if (words.size() != Count) lines.fail(quoted(text), expected);
    for (std::size_t i = 0; i < Count; ++i) {
        const auto [end, error] = std::from_chars(words[i].data(), words[i].data() + words[i].size(), values[i]);
        const bool whole = error == std::errc{} && end == words[i].data() + words[i].size();
        if (!whole || !std::isfinite(values[i])) lines.fail(quoted(text), expected);
    }
    return values;
}

/// A factor that later lines multiply.
void multiply(double& factor, double by, std::string_view text, const LineReader& lines, const char* expected) {
    factor *= by;
    if (!(by > 0.0) || !(factor > 1e-30 && factor < 1e30)) lines.fail(quoted(text), expected);
}

/// None for eight zeros, as Photoshop writes where it has none to say.
std::optional<RgbSpace> space_of(std::string_view text, const LineReader& lines) {
    constexpr const char* kExpected = "x and y of red, green, blue and white, not on one line";
    const auto v = numbers<8>(text, lines, kExpected);
    if (std::all_of(v.begin(), v.end(), [](double x) { return x == 0.0; })) return std::nullopt;
    RgbSpace space{"PRIMARIES", {v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, {v[6], v[7]}};
    try {
        (void)rgb_from_xyz(space);
    } catch (const std::invalid_argument&) {
        lines.fail(quoted(text), kExpected);
    }
    return space;
}

void read_variable(std::string_view line, const LineReader& lines, RadianceHeader& header) {
    const std::size_t equals = line.find('=');
    if (line.starts_with('#') || equals == std::string_view::npos) return;
    const std::string_view name = line.substr(0, equals), text = line.substr(equals + 1);
    if (name == "FORMAT") {
        const std::vector<std::string_view> words = words_of(text);
        const std::string_view format = words.size() == 1 ? words[0] : text;
        if (format == "32-bit_rle_rgbe") {
            header.format = RadianceFormat::rgbe;
        } else if (format == "32-bit_rle_xyze") {
            header.format = RadianceFormat::xyze;
        } else {
            lines.fail("FORMAT " + quoted(text), "32-bit_rle_rgbe or 32-bit_rle_xyze");
        }
    } else if (name == "EXPOSURE") {
        constexpr const char* kExpected = "an EXPOSURE above 0, and a product of all in (1e-30, 1e30)";
        multiply(header.exposure, numbers<1>(text, lines, kExpected)[0], text, lines, kExpected);
    } else if (name == "COLORCORR") {
        constexpr const char* kExpected = "a COLORCORR of three numbers above 0, and products of all in (1e-30, 1e30)";
        const auto by = numbers<3>(text, lines, kExpected);
        for (std::size_t i = 0; i < 3; ++i) multiply(header.correction[i], by[i], text, lines, kExpected);
    } else if (name == "PRIMARIES") {
        header.space = space_of(text, lines);
    }
}

/// "-Y 512 +X 1024"
void read_resolution(std::string_view line, const LineReader& lines, RadianceHeader& header) {
    const std::string expected = "a size such as -Y 512 +X 1024, of 1 to 1048576 pixels each";
    const std::vector<std::string_view> words = words_of(line);
    const auto is_axis = [](std::string_view word, char axis) {
        return word.size() == 2 && (word[0] == '-' || word[0] == '+') && word[1] == axis;
    };
    if (words.size() != 4) lines.fail(quoted(line), expected);
    header.rows = is_axis(words[0], 'Y');
    if (!is_axis(words[0], header.rows ? 'Y' : 'X') || !is_axis(words[2], header.rows ? 'X' : 'Y')) {
        lines.fail(quoted(line), expected);
    }
    const auto size = [&](std::string_view word) {
        int value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        const bool whole = error == std::errc{} && end == word.data() + word.size();
        if (!whole || value < 1 || value > kMostPixels) lines.fail(quoted(line), expected);
        return value;
    };
    const std::size_t y = header.rows ? 0 : 2, x = 2 - y;
    header.forward_y = words[y][0] == '-';
    header.forward_x = words[x][0] == '+';
    header.height = size(words[y + 1]);
    header.width = size(words[x + 1]);
}

}  // namespace

RadianceHeader read_radiance_header(const std::filesystem::path& path, std::string_view bytes) {
    LineReader lines(path, bytes);
    RadianceHeader header;
    const std::string_view first = lines.next("#?RADIANCE");
    if (!first.starts_with("#?")) lines.fail(quoted(first), "#?RADIANCE");
    for (std::string_view line; !(line = lines.next("a variable, or the empty line after them")).empty();) {
        read_variable(line, lines, header);
    }
    read_resolution(lines.next("a size such as -Y 512 +X 1024"), lines, header);
    header.begin = lines.at();
    return header;
}

}  // namespace emulsion
