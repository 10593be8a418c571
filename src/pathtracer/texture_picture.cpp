#include "pathtracer/texture_picture.h"

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
#include "film/exr_numbers.h"
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

DecodedPicture decoded(CodedImage coded, const TextureEncoding& encoding) {
    const std::vector<float> value_of_code = decoded_codes(encoding, coded.largest_code);
    const auto channels = static_cast<std::size_t>(coded.channels), green = std::min<std::size_t>(channels - 1, 1);
    const auto value = [&](std::size_t i) { return value_of_code[coded.code[i]]; };
    DecodedPicture picture{.rgb = Image<RGB>(coded.width, coded.height, UnsetPixels{})};
    if (coded.largest_code == 255) picture.byte_codes = encoding;
    bool is_opaque = true;
    for (std::size_t i = 0; i < picture.rgb.pixels().size(); ++i) {
        const std::size_t at = i * channels;
        picture.rgb.pixels()[i] = {value(at), value(at + green), value(at + 2 * green)};
        if (channels == 4) is_opaque = is_opaque && coded.code[at + 3] == coded.largest_code;
    }
    if (is_opaque) return picture;
    picture.alpha.emplace(coded.width, coded.height, UnsetPixels{});
    for (std::size_t i = 0; i < picture.alpha->pixels().size(); ++i)
        picture.alpha->pixels()[i] = value(i * channels + 3);
    return picture;
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

/// Pictures of R G B or of one channel; none of others.
std::optional<DecodedPicture> read_exr_picture(const std::filesystem::path& path) {
    ExrNumbers numbers = read_exr_numbers(path);
    std::vector<FloatChannel>& channels = numbers.channels;
    if (channels.empty()) return std::nullopt;
    const auto& red = channels[0].values.pixels();
    const auto& green = channels[channels.size() == 1 ? 0 : 1].values.pixels();
    const auto& blue = channels[channels.size() == 1 ? 0 : 2].values.pixels();
    DecodedPicture picture{.rgb = Image<RGB>(channels[0].values.width(), channels[0].values.height(), UnsetPixels{})};
    for (std::size_t i = 0; i < red.size(); ++i) picture.rgb.pixels()[i] = {red[i], green[i], blue[i]};
    const auto is_one = [](float value) { return value == 1.0f; };
    if (channels.size() == 4 && !std::ranges::all_of(channels[3].values.pixels(), is_one)) {
        picture.alpha = std::move(channels[3].values);
    }
    if (!numbers.space) return picture;
    const std::optional<ColorSpace> space = color_space_with_primaries_of(*numbers.space);
    picture.space = space.value_or(ColorSpace::srgb);
    if (!space) picture.note = "its chromaticities are those of no space that is known: taken as sRGB, as in pbrt-v4";
    return picture;
}

DecodedPicture read_exr_any(const std::filesystem::path& path) {
    if (auto picture = read_exr_picture(path)) return std::move(*picture);
    const FilmImage image = read_exr(path, {.layers = ExrLayers::skip});
    const double scale = 1.0 / image.white_luminance_cdm2;
    return {.rgb = rgb_of(image.xyz, rgb_space("sRGB"), {scale, scale, scale})};
}

/// Of a format that has linear values.
DecodedPicture read_linear(const std::filesystem::path& path, std::string_view bytes, PictureFormat format) {
    switch (format) {
        case PictureFormat::radiance:
            return {.rgb = read_radiance_rgb(path, bytes)};
        case PictureFormat::pfm:
            return {.rgb = rgb_of(read_pfm(path).xyz, rgb_space("sRGB"), {1.0, 1.0, 1.0})};
        default:
            return read_exr_any(path);
    }
}

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

DecodedPicture read_picture(const std::filesystem::path& path, std::string_view bytes,
                            const TextureEncoding& encoding) {
    const PictureFormat format = picture_format(path);
    if (format == PictureFormat::png) return decoded(decode_png(path, bytes), encoding);
    if (format == PictureFormat::jpeg) return decoded(decode_jpeg(path, bytes), SrgbTransfer{});
    DecodedPicture picture = read_linear(path, bytes, format);
    check_finite(path, picture.rgb);
    return picture;
}

}  // namespace emulsion
