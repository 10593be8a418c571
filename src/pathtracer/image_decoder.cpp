#include "pathtracer/image_decoder.h"

#include <cstdlib>
#include <limits>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "core/error.h"
#include "pathtracer/image_file_check.h"

// Of stb_image only what is needed, and nothing that other translation units could see. Its memory is cleared: tables
// that a damaged file uses and never defines are then empty, not what was there before (CVE-2022-28042).
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(memory, size) std::realloc(memory, size)
#define STBI_FREE(memory) std::free(memory)
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace emulsion {

namespace {

struct FreeStb {
    void operator()(void* memory) const noexcept { stbi_image_free(memory); }
};
template <class Code>
using StbPixels = std::unique_ptr<Code, FreeStb>;

/// What stb_image wants of a file.
struct StbBytes {
    const stbi_uc* data;
    int size;
};

StbBytes stb_bytes(const std::filesystem::path& path, std::string_view bytes) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw IoError(path, fmt::format("a picture file of {} bytes, expected at most 2^31 - 1", bytes.size()));
    }
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): chars seen as unsigned chars
    return {reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size())};
}

[[noreturn]] void fail(const std::filesystem::path& path) {
    throw IoError(path, fmt::format("is no picture that can be decoded ({})", stbi_failure_reason()));
}

void check_size(const std::filesystem::path& path, const StbBytes& file) {
    int width = 0, height = 0, channels = 0;
    if (stbi_info_from_memory(file.data, file.size, &width, &height, &channels) == 0) fail(path);
    if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > kMaxTexels) {
        throw IoError(path, fmt::format("{} x {} pixels, expected at most {} in all", width, height, kMaxTexels));
    }
}

/// Takes over the first channels of each pixel.
template <class Code>
void take_codes(CodedImage& image, const Code* pixels, int channels_there) {
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto kept = static_cast<std::size_t>(image.channels), there = static_cast<std::size_t>(channels_there);
    image.largest_code = std::numeric_limits<Code>::max();
    image.code.resize(count * kept);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < kept; ++c) image.code[i * kept + c] = pixels[i * there + c];
    }
}

enum class Alpha { keep, drop };

int channels_kept(int channels, Alpha alpha) noexcept {
    if (channels == 2) return 1;
    return channels == 4 && alpha == Alpha::drop ? 3 : channels;
}

CodedImage decode(const std::filesystem::path& path, std::string_view bytes, Alpha alpha) {
    const StbBytes file = stb_bytes(path, bytes);
    check_size(path, file);
    CodedImage image;
    int channels = 0;
    if (stbi_is_16_bit_from_memory(file.data, file.size) != 0) {
        const StbPixels<stbi_us> pixels(
            stbi_load_16_from_memory(file.data, file.size, &image.width, &image.height, &channels, 0));
        if (!pixels) fail(path);
        image.channels = channels_kept(channels, alpha);
        take_codes(image, pixels.get(), channels);
    } else {
        const StbPixels<stbi_uc> pixels(
            stbi_load_from_memory(file.data, file.size, &image.width, &image.height, &channels, 0));
        if (!pixels) fail(path);
        image.channels = channels_kept(channels, alpha);
        take_codes(image, pixels.get(), channels);
    }
    return image;
}

}  // namespace

CodedImage decode_png(const std::filesystem::path& path, std::string_view bytes) {
    check_png(path, bytes);
    constexpr std::size_t kColourTypeAt = 25;  // in IHDR, the first chunk
    constexpr char kColourAndAlpha = 6;
    const bool has_alpha = bytes.size() > kColourTypeAt && bytes[kColourTypeAt] == kColourAndAlpha;
    return decode(path, bytes, has_alpha ? Alpha::keep : Alpha::drop);
}

CodedImage decode_jpeg(const std::filesystem::path& path, std::string_view bytes) {
    check_jpeg(path, bytes);
    return decode(path, bytes, Alpha::drop);
}

}  // namespace emulsion
