#include "display/png_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include <png.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "display/png_color.h"
#include "display/png_handle.h"

namespace emulsion {

namespace {

/// What the callbacks share with the caller.
struct WriteState {
    std::FILE* file = nullptr;
    int write_errno = 0;  ///< of a write that failed
};

void on_write(png_structp png, png_bytep data, std::size_t size) {
    auto& state = *static_cast<WriteState*>(png_get_io_ptr(png));
    if (std::fwrite(data, 1, size, state.file) == size) return;
    state.write_errno = errno;
    png_error(png, "cannot write");
}

void on_flush(png_structp /*png*/) {}  // flushed and checked when the file is closed

struct FileCloser {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};

bool is_ascii(std::string_view text) noexcept {
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
}

void check_text(const PngText& text) {
    const std::string& keyword = text.keyword;
    const bool printable = std::all_of(keyword.begin(), keyword.end(), [](char c) { return c >= ' ' && c <= '~'; });
    const bool spaced = keyword.starts_with(' ') || keyword.ends_with(' ') || keyword.find("  ") != std::string::npos;
    if (keyword.empty() || keyword.size() > 79 || !printable || spaced) {
        throw std::invalid_argument("PNG keyword \"" + keyword +
                                    "\": must be 1 to 79 printable ASCII characters, with single spaces inside only");
    }
    if (text.text.find('\0') != std::string::npos) {
        throw std::invalid_argument("PNG text of \"" + keyword + "\": must not hold '\\0'");
    }
}

void check_codes(const Image<CodeRGB>& image, int bits) {
    const int most = (1 << bits) - 1;
    for (const CodeRGB& code : image.pixels()) {
        const int largest = std::max({code.r, code.g, code.b});
        if (largest <= most) continue;
        throw std::invalid_argument("PNG code " + std::to_string(largest) + ": has more than " + std::to_string(bits) +
                                    " bits");
    }
}

/// Text chunks as libpng wants them. It only reads the strings that they point to, which stay the caller's.
std::vector<png_text> text_chunks(const PngOptions& options) {
    std::vector<png_text> chunks;
    chunks.reserve(options.text.size());
    for (const PngText& text : options.text) {
        png_text chunk{};
        chunk.compression = is_ascii(text.text) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        chunk.key = const_cast<char*>(text.keyword.c_str());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
        chunk.text = const_cast<char*>(text.text.c_str());    // NOLINT(cppcoreguidelines-pro-type-const-cast)
        chunks.push_back(chunk);
    }
    return chunks;
}

/// What the file says about its samples, and how they are packed.
struct SampleFormat {
    int code_bits = 8;
    CodeRange range;
    PngColor color;
    PngCompression compression;
    [[nodiscard]] int depth() const noexcept { return code_bits <= 8 ? 8 : 16; }
    [[nodiscard]] std::size_t pixel_bytes() const noexcept { return static_cast<std::size_t>(3 * depth() / 8); }
};

/// The samples of a row as they stand in the file, most significant byte first.
void put_row(std::span<const CodeRGB> codes, const SampleFormat& format, std::span<png_byte> bytes) noexcept {
    const std::uint32_t most = (1u << format.code_bits) - 1u, whole = (1u << format.depth()) - 1u;
    const int shift = format.depth() - format.code_bits;
    const bool narrow = std::holds_alternative<NarrowRange>(format.range);
    std::size_t at = 0;
    for (const CodeRGB& code : codes) {
        for (const std::uint32_t component : {code.r, code.g, code.b}) {
            const std::uint32_t sample = narrow ? component << shift : (component * whole + most / 2) / most;
            if (format.depth() == 16) bytes[at++] = static_cast<png_byte>(sample >> 8u);
            bytes[at++] = static_cast<png_byte>(sample & 0xffu);
        }
    }
}

// What the codes mean, in libpng's words. Only plain values in these, too.
void set_color(png_structp png, png_infop info, const PngSrgb& /*color*/) {
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_RELATIVE);
}
void set_color(png_structp png, png_infop info, const PngGamma& color) {
    const RgbSpace& space = color.space;
    png_set_gAMA(png, info, 1.0 / color.exponent);
    png_set_cHRM(png, info, space.white.x, space.white.y, space.red.x, space.red.y, space.green.x, space.green.y,
                 space.blue.x, space.blue.y);
}
void set_color(png_structp png, png_infop info, const PngProfile& color) {
    png_set_iCCP(
        png, info, "Emulsion", PNG_COMPRESSION_TYPE_BASE,
        reinterpret_cast<png_const_bytep>(color.icc.data()),  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
        static_cast<png_uint_32>(color.icc.size()));
}
void set_color(png_structp png, png_infop info, const PngCodePoints& color) {
    std::array<png_byte, 4> data = {color.primaries, color.transfer, 0, color.full_range ? png_byte{1} : png_byte{0}};
    // libpng 1.6.39 does not know the chunk, and writes those only that it is told to.
    constexpr std::array<png_byte, 5> kName = {'c', 'I', 'C', 'P', '\0'};
    png_unknown_chunk chunk{{'c', 'I', 'C', 'P', '\0'}, data.data(), data.size(), PNG_HAVE_IHDR};
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, kName.data(), 1);
    png_set_unknown_chunks(png, info, &chunk, 1);
}

/// False if libpng reported an error. Only plain values here: errors jump out of the middle. `row` has room for one.
bool write_chunks(png_structp png, png_infop info, const Image<CodeRGB>& image, const SampleFormat& format,
                  std::span<const png_text> text, std::span<png_byte> row) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    constexpr png_uint_32 kAnySize = 0x7fffffff;
    png_set_user_limits(png, kAnySize, kAnySize);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width()), static_cast<png_uint_32>(image.height()),
                 format.depth(), PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, format.compression.level);
    png_set_compression_strategy(png, format.compression.strategy);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, format.compression.filters);
    std::visit([&](const auto& color) { set_color(png, info, color); }, format.color);
    if (format.code_bits != format.depth()) {
        png_color_8 bits{};
        bits.red = bits.green = bits.blue = static_cast<png_byte>(format.code_bits);
        png_set_sBIT(png, info, &bits);
    }
    if (!text.empty()) png_set_text(png, info, text.data(), static_cast<int>(text.size()));
    png_write_info(png, info);
    for (int y = 0; y < image.height(); ++y) {
        put_row(image.row(y), format, row);
        png_write_row(png, row.data());
    }
    png_write_end(png, info);
    return true;
}

/// \throws IoError unless all of the image is in the temporary file.
void write_image(const AtomicFile& file, const Image<CodeRGB>& image, const SampleFormat& format,
                 std::span<const png_text> text) {
    std::vector<png_byte> row(static_cast<std::size_t>(image.width()) * format.pixel_bytes());
    WriteState state;
    std::unique_ptr<std::FILE, FileCloser> stream(std::fopen(file.temporary_path().c_str(), "wb"));
    if (stream == nullptr) throw IoError(file.path(), "cannot open the temporary file: " + errno_text(errno));
    state.file = stream.get();
    {
        PngMessage message;
        const PngHandle writer(PngTask::write, message);
        if (!writer.created()) throw IoError(file.path(), "libpng could not be started");
        png_set_write_fn(writer.png(), &state, on_write, on_flush);
        const bool written = write_chunks(writer.png(), writer.info(), image, format, text, row);
        if (state.write_errno != 0) throw IoError(file.path(), "cannot write: " + errno_text(state.write_errno));
        if (!written || message.text[0] != '\0') {
            throw IoError(file.path(), std::string("libpng: ") + message.text.data());
        }
    }
    if (std::fclose(stream.release()) != 0) throw IoError(file.path(), "cannot write: " + errno_text(errno));
}

}  // namespace

void validate(const PngOptions& options) {
    check_range(options.bits, kCodeBits, "PNG bits");
    (void)code_scale(options.bits, options.color.range);
    (void)png_color(options.color);
    (void)png_compression(options.level, options.bits);
    for (const PngText& text : options.text) check_text(text);
}

void write_png(const std::filesystem::path& path, const Image<CodeRGB>& image, const PngOptions& options) {
    validate(options);
    if (image.width() < 1 || image.height() < 1) throw std::invalid_argument("PNG of an empty picture");
    check_codes(image, options.bits);
    const SampleFormat format{options.bits, options.color.range, png_color(options.color),
                              png_compression(options.level, options.bits)};
    const std::vector<png_text> text = text_chunks(options);
    AtomicFile file(path);
    write_image(file, image, format, text);
    file.commit();
}

}  // namespace emulsion
