#include "pathtracer/scene_imagemap.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "core/visit.h"
#include "pathtracer/scene_transform.h"
#include "pathtracer/texture_image.h"

namespace emulsion {

namespace {

TextureWrap read_wrap(const ParameterList& list) {
    const std::string wrap = string_or(list, "wrap", "repeat");
    if (wrap == "black") return TextureWrap::black;
    if (wrap == "clamp") return TextureWrap::clamp;
    return wrap == "repeat" ? TextureWrap::repeat : TextureWrap::octahedral_sphere;
}

/// The exponent of "gamma 2.2".
std::optional<double> exponent_of(std::string_view text) {
    constexpr std::string_view kGamma = "gamma ";
    if (!text.starts_with(kGamma)) return std::nullopt;
    text.remove_prefix(std::min(text.find_first_not_of(' ', kGamma.size()), text.size()));
    double exponent = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return exponent;
}

TextureEncoding read_encoding(const ParameterList& list, PictureFormat format, const TextureContext& context) {
    const SceneParameter* const parameter = find_parameter(list, "encoding");
    if (parameter == nullptr) return SrgbTransfer{};
    const std::string& text = parameter->strings.front();
    if (format != PictureFormat::png) {
        context.warnings.add(
            parameter->place,
            fmt::format("the encoding {} is that of PNG pictures only, as in pbrt-v4: {}", quote(text),
                        format == PictureFormat::jpeg ? "a JPEG is taken as sRGB" : "the file's numbers are linear"));
    }
    if (text == "sRGB") return SrgbTransfer{};
    if (text == "linear") return LinearTransfer{};
    const ParameterRange& range = GammaTransfer::kParameters[0].range;
    const std::optional<double> exponent = exponent_of(text);
    if (exponent && *exponent >= range.min && *exponent <= range.max) return GammaTransfer{*exponent};
    throw SceneError(parameter->first_value, fmt::format("the encoding {}", quote(text)),
                     fmt::format("sRGB, linear, or gamma and an exponent from {} to {}", range.min, range.max));
}

std::string key_of(const std::filesystem::path& path, const TextureEncoding& encoding, TextureFilter filter,
                   TextureWrap wrap) {
    const auto* const gamma = std::get_if<GammaTransfer>(&encoding);
    return fmt::format("{} {} {} {} {}", encoding.index(), gamma == nullptr ? 0.0 : gamma->exponent,
                       static_cast<int>(filter), static_cast<int>(wrap), path.string());
}

/// What the file's pictures are to a texture of numbers, or of reflectances.
template <class Texel>
TextureImage<Texel> read_image(const SceneParameter& file, const TextureEncoding& encoding, TextureFilter filter,
                               TextureWrap wrap, const TextureContext& context) {
    const std::string& name = file.strings.front();
    const std::filesystem::path path = context.files.path_of(name);
    const std::string bytes = context.files.read(name);
    if constexpr (std::is_same_v<Texel, float>) {
        return {path, read_number_texels(path, bytes, encoding, filter, wrap)};
    } else {
        RgbTexels read = read_rgb_texels(path, bytes, encoding, wrap);
        if (!read.note.empty()) {
            context.warnings.add(file.first_value, fmt::format("picture {}: {}", quote(name), read.note));
        }
        return {path, std::move(read.texels), read.space};
    }
}

}  // namespace

namespace {

Imath::M44d texture_from_world(const ParameterList& list, std::string_view mapping, const TextureContext& context) {
    if (const std::optional<Imath::M44d> inverse = inverse_of(context.world_from_texture)) return *inverse;
    throw SceneError(list.place, fmt::format("a {} mapping in a space that can't be reached", mapping),
                     "a transformation that double precision can undo");
}

}  // namespace

SolidTextureMapping read_solid_mapping(const ParameterList& list, const TextureContext& context) {
    return {texture_from_world(list, "solid", context)};
}

TextureMapping read_texture_mapping(const ParameterList& list, const TextureContext& context) {
    const std::string mapping = string_or(list, "mapping", "uv");
    const double delta_u = real_or(list, "udelta", 0.0), delta_v = real_or(list, "vdelta", 0.0);
    if (mapping == "uv") {
        return UvMapping{real_or(list, "uscale", 1.0), real_or(list, "vscale", 1.0), delta_u, delta_v};
    }
    const Imath::M44d inverse = texture_from_world(list, mapping, context);
    if (mapping == "spherical") return SphericalTextureMapping{inverse};
    if (mapping == "cylindrical") return CylindricalTextureMapping{inverse};
    return PlanarTextureMapping{inverse, point_or(list, "v1", {1.0, 0.0, 0.0}), point_or(list, "v2", {0.0, 1.0, 0.0}),
                                delta_u, delta_v};
}

template <>
ImagemapReader::Images<float>& ImagemapReader::images() noexcept {
    return number_images_;
}
template <>
ImagemapReader::Images<RGB>& ImagemapReader::images() noexcept {
    return rgb_images_;
}

TextureFilter ImagemapReader::read_filter(const ParameterList& list, const TextureContext& context) {
    const std::string filter = string_or(list, "filter", "bilinear");
    if (filter == "point") return TextureFilter::nearest;
    if (filter == "bilinear") return TextureFilter::bilinear;
    if (!std::exchange(warned_of_filter_, true)) {
        context.warnings.add(find_parameter(list, "filter")->place,
                             fmt::format("the filter {} is that of no level but the picture itself, here and further "
                                         "on: textures are not filtered over pixels but by the samples of pixels",
                                         quote(filter)));
    }
    return filter == "trilinear" ? TextureFilter::bilinear : TextureFilter::gaussian;
}

template <class Texel>
ImageTexture<Texel> ImagemapReader::read(const ParameterList& list, const TextureContext& context) {
    ImageTexture<Texel> texture;
    texture.mapping = read_texture_mapping(list, context);
    texture.wrap = read_wrap(list);
    texture.scale = real_or(list, "scale", 1.0);
    texture.invert = flag_or(list, "invert", Flag::off) == Flag::on;

    texture.filter = read_filter(list, context);

    const SceneParameter* const file = find_parameter(list, "filename");
    if (file == nullptr) throw SceneError(list.place, "an imagemap without a file", "a parameter \"string filename\"");
    const std::string& name = file->strings.front();
    const std::filesystem::path path = context.files.path_of(name);
    try {
        const TextureEncoding encoding = read_encoding(list, picture_format(path), context);
        auto& image = images<Texel>()[key_of(path, encoding, texture.filter, texture.wrap)];
        if (!image) {
            image = std::make_shared<const TextureImage<Texel>>(
                read_image<Texel>(*file, encoding, texture.filter, texture.wrap, context));
        }
        texture.image = image;
    } catch (const IoError& error) {
        throw SceneError(file->first_value, fmt::format("picture {} ({})", quote(name), error.reason()),
                         "one that can be read");
    }
    return texture;
}

template ImageTexture<float> ImagemapReader::read(const ParameterList&, const TextureContext&);
template ImageTexture<RGB> ImagemapReader::read(const ParameterList&, const TextureContext&);

}  // namespace emulsion
