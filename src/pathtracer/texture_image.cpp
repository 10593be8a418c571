#include "pathtracer/texture_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/matrix3.h"
#include "core/visit.h"
#include "film/exr_file.h"
#include "film/pfm_file.h"
#include "film/radiance_file.h"
#include "film/radiance_header.h"
#include "pathtracer/image_decoder.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

namespace {

/// The linear value of every code.
std::vector<float> decoded_codes(const TextureEncoding& encoding, int largest_code) {
    std::vector<float> values(static_cast<std::size_t>(largest_code) + 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double encoded = static_cast<double>(i) / largest_code;
        values[i] = static_cast<float>(
            visit_noexcept([&](const auto& chosen) noexcept { return decode(chosen, encoded); }, encoding));
    }
    return values;
}

/// Linear values of a PNG or JPEG picture.
struct DecodedImage {
    CodedImage coded;
    std::vector<float> value_of_code;

    [[nodiscard]] std::size_t count() const noexcept {
        return coded.code.size() / static_cast<std::size_t>(coded.channels);
    }
    [[nodiscard]] float operator()(std::size_t pixel, int channel) const noexcept {
        const std::size_t at = pixel * static_cast<std::size_t>(coded.channels) + static_cast<std::size_t>(channel);
        return value_of_code[coded.code[at]];
    }
    [[nodiscard]] RGB rgb(std::size_t pixel) const noexcept {
        if (coded.channels == 1) return {(*this)(pixel, 0), (*this)(pixel, 0), (*this)(pixel, 0)};
        return {(*this)(pixel, 0), (*this)(pixel, 1), (*this)(pixel, 2)};
    }
    /// Whether there is an alpha that says something.
    [[nodiscard]] bool has_alpha() const noexcept {
        if (coded.channels != 4) return false;
        for (std::size_t i = 3; i < coded.code.size(); i += 4) {
            if (coded.code[i] != coded.largest_code) return true;
        }
        return false;
    }
};

DecodedImage decoded(const std::filesystem::path& path, std::string_view bytes, const TextureEncoding& encoding) {
    const bool png = picture_format(path) == PictureFormat::png;
    DecodedImage image{png ? decode_png(path, bytes) : decode_jpeg(path, bytes), {}};
    image.value_of_code = decoded_codes(png ? encoding : TextureEncoding{SrgbTransfer{}}, image.coded.largest_code);
    return image;
}

/// \throws IoError naming a texel that is no number to calculate with.
void check_finite(const std::filesystem::path& path, const Image<RGB>& image) {
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const RGB& texel = image(x, y);
            if (std::isfinite(texel.r) && std::isfinite(texel.g) && std::isfinite(texel.b)) continue;
            throw IoError(path, fmt::format("texel ({}, {}): found {} {} {}, expected finite numbers", x, y, texel.r,
                                            texel.g, texel.b));
        }
    }
}

/// `scale` times the RGB of XYZ.
/// The way over XYZ leaves greys that are none and zeros that are negative: what lies within its rounding is set right.
RGB without_rounding(RGB c) noexcept {
    const float largest = std::max({std::abs(c.r), std::abs(c.g), std::abs(c.b)}), rounding = 2e-6f * largest;
    if (std::abs(c.r - c.g) <= rounding && std::abs(c.g - c.b) <= rounding) return {c.g, c.g, c.g};
    for (float* component : {&c.r, &c.g, &c.b}) {
        if (std::abs(*component) <= rounding) *component = 0.0f;
    }
    return c;
}

Image<RGB> rgb_of(const Image<XYZ>& xyz, const RgbSpace& space, const std::array<double, 3>& scale) {
    const Matrix3 rgb_of_xyz = rgb_from_xyz(space);
    Image<RGB> image(xyz.width(), xyz.height(), UnsetPixels{});
    std::transform(xyz.pixels().begin(), xyz.pixels().end(), image.pixels().begin(), [&](const XYZ& p) {
        const auto rgb = rgb_of_xyz * std::array<double, 3>{p.x, p.y, p.z};
        return without_rounding({static_cast<float>(scale[0] * rgb[0]), static_cast<float>(scale[1] * rgb[1]),
                                 static_cast<float>(scale[2] * rgb[2])});
    });
    return image;
}

Image<RGB> read_radiance_rgb(const std::filesystem::path& path, std::string_view bytes) {
    const RadianceHeader header = read_radiance_header(path, bytes);
    std::array<double, 3> scale{};
    for (std::size_t i = 0; i < 3; ++i) scale[i] = header.exposure * header.correction[i];
    return rgb_of(read_radiance(path).xyz, header.space.value_or(rgb_space("sRGB")), scale);
}

Image<RGB> read_exr_rgb(const std::filesystem::path& path) {
    const FilmImage image = read_exr(path, {.layers = ExrLayers::skip});
    const double scale = 1.0 / image.white_luminance_cdm2;
    return rgb_of(image.xyz, rgb_space("sRGB"), {scale, scale, scale});
}

/// Of a format that has linear values.
Image<RGB> read_linear(const std::filesystem::path& path, std::string_view bytes, PictureFormat format) {
    Image<RGB> image = format == PictureFormat::radiance ? read_radiance_rgb(path, bytes)
                       : format == PictureFormat::pfm ? rgb_of(read_pfm(path).xyz, rgb_space("sRGB"), {1.0, 1.0, 1.0})
                                                      : read_exr_rgb(path);
    check_finite(path, image);
    return image;
}

bool has_codes(PictureFormat format) noexcept { return format == PictureFormat::png || format == PictureFormat::jpeg; }

}  // namespace

PictureFormat picture_format(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (ending == ".png") return PictureFormat::png;
    if (ending == ".jpg" || ending == ".jpeg") return PictureFormat::jpeg;
    if (ending == ".hdr") return PictureFormat::radiance;
    if (ending == ".pfm") return PictureFormat::pfm;
    if (ending == ".exr") return PictureFormat::exr;
    throw IoError(path, "a name that ends in none of .png .jpg .jpeg .hdr .pfm .exr");
}

Image<RGB> read_rgb_texels(const std::filesystem::path& path, std::string_view bytes, const TextureEncoding& encoding) {
    const PictureFormat format = picture_format(path);
    if (!has_codes(format)) return read_linear(path, bytes, format);
    const DecodedImage decoded_image = decoded(path, bytes, encoding);
    Image<RGB> image(decoded_image.coded.width, decoded_image.coded.height, UnsetPixels{});
    for (std::size_t i = 0; i < decoded_image.count(); ++i) image.pixels()[i] = decoded_image.rgb(i);
    return image;
}

Image<float> read_number_texels(const std::filesystem::path& path, std::string_view bytes,
                                const TextureEncoding& encoding, TextureFilter filter) {
    const auto number_of = [&](const RGB& rgb) {
        return filter == TextureFilter::nearest ? rgb.r : (rgb.r + rgb.g + rgb.b) / 3.0f;
    };
    const PictureFormat format = picture_format(path);
    if (!has_codes(format)) {
        const Image<RGB> rgb = read_linear(path, bytes, format);
        Image<float> image(rgb.width(), rgb.height(), UnsetPixels{});
        std::transform(rgb.pixels().begin(), rgb.pixels().end(), image.pixels().begin(), number_of);
        return image;
    }
    const DecodedImage decoded_image = decoded(path, bytes, encoding);
    const bool alpha = filter != TextureFilter::nearest && decoded_image.has_alpha();
    Image<float> image(decoded_image.coded.width, decoded_image.coded.height, UnsetPixels{});
    for (std::size_t i = 0; i < decoded_image.count(); ++i) {
        image.pixels()[i] = alpha ? decoded_image(i, 3) : number_of(decoded_image.rgb(i));
    }
    return image;
}

}  // namespace emulsion
