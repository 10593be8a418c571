#include "pathtracer/scene_imagemap.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "core/error.h"
#include "core/visit.h"
#include "pathtracer/scene_transform.h"
#include "pathtracer/texture_image.h"

namespace emulsion {

namespace {

void warn(const TextureContext& context, const SourcePlace& place, const std::string& what) {
    context.scene.warnings.push_back(to_text(place) + ": " + what);
}

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
        warn(context, parameter->place,
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

std::string key_of(const std::filesystem::path& path, const TextureEncoding& encoding, TextureFilter filter) {
    const auto* const gamma = std::get_if<GammaTransfer>(&encoding);
    return fmt::format("{} {} {} {}", encoding.index(), gamma == nullptr ? 0.0 : gamma->exponent,
                       static_cast<int>(filter), path.string());
}

}  // namespace

TextureMapping read_texture_mapping(const ParameterList& list, const TextureContext& context) {
    const std::string mapping = string_or(list, "mapping", "uv");
    const double delta_u = real_or(list, "udelta", 0.0), delta_v = real_or(list, "vdelta", 0.0);
    if (mapping == "uv") {
        return UvMapping{real_or(list, "uscale", 1.0), real_or(list, "vscale", 1.0), delta_u, delta_v};
    }
    const std::optional<Imath::M44d> texture_from_world = inverse_of(context.world_from_texture);
    if (!texture_from_world) {
        throw SceneError(list.place, fmt::format("a {} mapping in a space that can't be reached", mapping),
                         "a transformation that double precision can undo");
    }
    if (mapping == "spherical") return SphericalTextureMapping{*texture_from_world};
    if (mapping == "cylindrical") return CylindricalTextureMapping{*texture_from_world};
    return PlanarTextureMapping{*texture_from_world, point_or(list, "v1", {1.0, 0.0, 0.0}),
                                point_or(list, "v2", {0.0, 1.0, 0.0}), delta_u, delta_v};
}

template <>
ImagemapReader::Images<float>& ImagemapReader::images() noexcept {
    return number_images_;
}
template <>
ImagemapReader::Images<RGB>& ImagemapReader::images() noexcept {
    return rgb_images_;
}

template <class Texel>
ImageTexture<Texel> ImagemapReader::read(const ParameterList& list, const TextureContext& context) {
    ImageTexture<Texel> texture;
    texture.mapping = read_texture_mapping(list, context);
    texture.wrap = read_wrap(list);
    texture.scale = real_or(list, "scale", 1.0);
    texture.invert = flag_or(list, "invert", Flag::off) == Flag::on;

    const std::string filter = string_or(list, "filter", "bilinear");
    texture.filter = filter == "point" ? TextureFilter::nearest : TextureFilter::bilinear;
    if (filter != "point" && filter != "bilinear" && !warned_of_filter_) {
        warned_of_filter_ = true;
        warn(context, find_parameter(list, "filter")->place,
             fmt::format("the filter {} is taken as \"bilinear\", here and further on: textures are not filtered over "
                         "pixels but by the samples of pixels",
                         quote(filter)));
    }

    const SceneParameter* const file = find_parameter(list, "filename");
    if (file == nullptr) throw SceneError(list.place, "an imagemap without a file", "a parameter \"string filename\"");
    const std::string& name = file->strings.front();
    const std::filesystem::path path = context.files.path_of(name);
    try {
        const TextureEncoding encoding = read_encoding(list, picture_format(path), context);
        auto& image = images<Texel>()[key_of(path, encoding, texture.filter)];
        if (!image) {
            const std::string bytes = context.files.read(name);
            if constexpr (std::is_same_v<Texel, float>) {
                image = std::make_shared<const TextureImage<float>>(
                    TextureImage<float>{path, read_number_texels(path, bytes, encoding, texture.filter)});
            } else {
                image = std::make_shared<const TextureImage<RGB>>(
                    TextureImage<RGB>{path, read_rgb_texels(path, bytes, encoding)});
            }
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
