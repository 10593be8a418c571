#include "display/png_read.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <png.h>

#include "core/error.h"
#include "core/text_file.h"
#include "display/png_handle.h"
#include "spectrum/rgb_space.h"
#include "spectrum/transfer_function.h"

namespace emulsion {

namespace {

struct ReadState {
    std::string_view bytes;
    std::size_t at = 0;
};

void on_read(png_structp png, png_bytep data, std::size_t size) {
    auto& state = *static_cast<ReadState*>(png_get_io_ptr(png));
    if (state.bytes.size() - state.at < size) png_error(png, "the file ends in the middle");
    std::memcpy(data, state.bytes.data() + state.at, size);
    state.at += size;
}

/// What stands before the picture; plain.
struct PngHeader {
    png_uint_32 width = 0, height = 0;
    std::size_t row_bytes = 0;  ///< of RGB, of 8 or of 16 bits
    int depth = 8;
    bool has_alpha = false, is_srgb = false, has_profile = false, has_gamma = false, has_primaries = false;
    double gamma = 0.0;
    std::array<double, 8> xy{};  ///< white, red, green, blue
};

/// False if libpng reported an error. Asks for RGB, of 16 bits where the file has 16.
/// \param most_bytes of memory for a chunk: a damaged length, of up to 2 GB, gets no more
bool read_header(png_structp png, png_infop info, std::size_t most_bytes, PngHeader& header) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    constexpr png_uint_32 kAnySize = 0x7fffffff;
    png_set_user_limits(png, kAnySize, kAnySize);
    png_set_chunk_malloc_max(png, most_bytes);
    png_read_info(png, info);
    header.has_alpha =
        (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
    header.has_profile = png_get_valid(png, info, PNG_INFO_iCCP) != 0;
    header.is_srgb = png_get_valid(png, info, PNG_INFO_sRGB) != 0;
    header.has_gamma = png_get_gAMA(png, info, &header.gamma) != 0;
    auto& xy = header.xy;
    header.has_primaries =
        png_get_cHRM(png, info, xy.data(), &xy[1], &xy[2], &xy[3], &xy[4], &xy[5], &xy[6], &xy[7]) != 0;
    png_set_expand(png);
    png_set_gray_to_rgb(png);
    png_set_strip_alpha(png);
    (void)png_set_interlace_handling(png);
    png_read_update_info(png, info);
    header.width = png_get_image_width(png, info);
    header.height = png_get_image_height(png, info);
    header.depth = png_get_bit_depth(png, info);
    header.row_bytes = png_get_rowbytes(png, info);
    return true;
}

bool read_rows(png_structp png, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_read_image(png, rows);
    png_read_end(png, nullptr);
    return true;
}

/// Whether there is a chunk of this type before the picture. The signature and all lengths were read by libpng.
bool has_chunk(std::string_view bytes, std::string_view type) noexcept {
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8u | static_cast<unsigned char>(bytes[at + i]);
        const std::string_view found = bytes.substr(at + 4, 4);
        if (found == type) return true;
        if (found == "IDAT") return false;
        at += 12 + length;
    }
    return false;
}

struct Meaning {
    RgbSpace space = rgb_space("sRGB");
    TransferFunction transfer = SrgbTransfer{};
    std::vector<std::string> notes;
};

Meaning meaning_of(const PngHeader& header, const std::filesystem::path& path) {
    Meaning meaning;
    if (header.has_alpha) meaning.notes.emplace_back("its alpha was left out");
    if (header.has_profile) {
        meaning.notes.emplace_back("its ICC profile was left out: taken as sRGB");
    } else if (header.is_srgb) {
        return meaning;
    } else if (!header.has_gamma && !header.has_primaries) {
        meaning.notes.emplace_back("neither sRGB nor gAMA and cHRM: taken as sRGB");
    } else {
        const auto& xy = header.xy;
        if (header.has_primaries) {
            meaning.space = {"cHRM", {xy[2], xy[3]}, {xy[4], xy[5]}, {xy[6], xy[7]}, {xy[0], xy[1]}};
        } else {
            meaning.notes.emplace_back("no cHRM: taken as Rec. 709 with the white D65");
        }
        if (header.has_gamma && !(header.gamma >= 0.2 && header.gamma <= 10.0)) {
            throw IoError(path, "PNG with gAMA " + std::to_string(header.gamma) + ", expected 0.2 to 10");
        }
        if (header.has_gamma) meaning.transfer = GammaTransfer{1.0 / header.gamma};
        if (!header.has_gamma) meaning.notes.emplace_back("no gAMA: taken as encoded as in sRGB");
    }
    return meaning;
}

/// Linear values of all samples of so many bits.
std::vector<float> decoded_samples(const TransferFunction& transfer, int depth) {
    std::vector<float> linear(std::size_t{1} << static_cast<unsigned>(depth));
    const auto most = static_cast<double>(linear.size() - 1);
    for (std::size_t i = 0; i < linear.size(); ++i) {
        linear[i] = static_cast<float>(decode(transfer, static_cast<double>(i) / most));
    }
    return linear;
}

Image<XYZ> decoded(const std::vector<png_byte>& bytes, const PngHeader& header, const Meaning& meaning) {
    const std::vector<float> linear = decoded_samples(meaning.transfer, header.depth);
    const Matrix3 matrix = xyz_from_rgb(meaning.space);
    Image<XYZ> xyz(static_cast<int>(header.width), static_cast<int>(header.height));
    std::size_t at = 0;
    const auto next = [&]() -> double {
        std::size_t sample = bytes[at++];
        if (header.depth == 16) sample = sample << 8u | bytes[at++];
        return linear[sample];
    };
    for (XYZ& pixel : xyz.pixels()) {
        const double r = next(), g = next(), b = next();
        const auto v = matrix * std::array{r, g, b};
        pixel = {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
    }
    return xyz;
}

}  // namespace

PngPicture read_png(const std::filesystem::path& path) {
    const std::string file = read_text_file(path);
    ReadState state{.bytes = file};
    PngMessage message;
    const PngHandle reader(PngTask::read, message);
    if (!reader.created()) throw IoError(path, "libpng could not be started");
    png_set_read_fn(reader.png(), &state, on_read);
    const auto fail = [&] {
        return IoError(path, "PNG, byte " + std::to_string(state.at) + ": libpng: " + message.text.data());
    };
    constexpr std::size_t kLargestUnpacked = 8'000'000;  // of packed text and profiles
    PngHeader header;
    if (!read_header(reader.png(), reader.info(), std::max(kLargestUnpacked, file.size()), header)) throw fail();
    if (has_chunk(file, "cICP")) {
        throw IoError(path, "PNG with a cICP chunk, which is not read; expected sRGB, gAMA and cHRM, or none");
    }
    Meaning meaning = meaning_of(header, path);

    // zlib packs 1032 bytes into one at best: a picture without the bytes for it gets no memory either.
    constexpr std::size_t kBestPacking = 1032;
    const std::size_t packed_bits = std::size_t{header.width} * header.height;  // at least a bit a pixel
    if (packed_bits / 8 / kBestPacking > file.size()) {
        throw IoError(path, "PNG of " + std::to_string(header.width) + "x" + std::to_string(header.height) +
                                " pixels: found " + std::to_string(file.size()) + " bytes, which can't hold them");
    }
    std::vector<png_byte> bytes(header.row_bytes * header.height);
    std::vector<png_bytep> rows(header.height);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = bytes.data() + y * header.row_bytes;
    if (!read_rows(reader.png(), rows.data())) throw fail();
    try {
        return {decoded(bytes, header, meaning), std::move(meaning.notes)};
    } catch (const std::invalid_argument& error) {
        throw IoError(path, std::string("PNG with primaries that no colour can be computed from: ") + error.what());
    }
}

}  // namespace emulsion
