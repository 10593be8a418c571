#include "pathtracer/scene_image_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

#include "core/error.h"
#include "pathtracer/equal_area.h"
#include "pathtracer/scene_color_space.h"
#include "pathtracer/texture_image.h"

namespace emulsion {

namespace {

/// The directions of light space in the world.
Imath::M44d rotation_of(const Imath::M44d& ctm, const SourcePlace& place) {
    const Imath::V3d x(ctm[0][0], ctm[0][1], ctm[0][2]), y(ctm[1][0], ctm[1][1], ctm[1][2]);
    const Imath::V3d z(ctm[2][0], ctm[2][1], ctm[2][2]);
    const double scale = x.length();
    // What a few transformations in single precision, as programs write them, leave of right angles.
    const double rounding = 1e-4 * scale;
    const auto differ = [&](double a, double b) { return !(std::abs(a - b) <= rounding); };
    if (differ(y.length(), scale) || differ(z.length(), scale) || differ(x.dot(y) / scale, 0.0) ||
        differ(y.dot(z) / scale, 0.0) || differ(z.dot(x) / scale, 0.0)) {
        throw SceneError(place, "the picture of an infinite light that is stretched or skewed",
                         "a transformation that rotates, mirrors, scales alike in all directions and moves");
    }
    const Imath::V3d i = x / scale, j = (y - i * i.dot(y)).normalized();
    const Imath::V3d k = i.cross(j) * (i.cross(j).dot(z) < 0.0 ? -1.0 : 1.0);
    return {i.x, i.y, i.z, 0, j.x, j.y, j.z, 0, k.x, k.y, k.z, 0, 0, 0, 0, 1};
}

RgbTexels read_texels(const SceneParameter& file, const LightContext& context) {
    const std::string& name = file.strings.front();
    try {
        const std::filesystem::path path = context.files.path_of(name);
        static_cast<void>(picture_format(path));  // before a large file of another kind is read
        return read_rgb_texels(path, context.files.read(name));
    } catch (const IoError& error) {
        throw SceneError(file.first_value, fmt::format("picture {} ({})", quote(name), error.reason()),
                         "one that can be read");
    }
}

/// What a surface that looks up gets of texels whose (1, 1, 1) has the luminance 1, by pbrt-v4's sum.
double illuminance_of(const Image<RGB>& texels, ColorSpace space) {
    const std::array<double, 3> luminance = xyz_from_rgb(rgb_space_of(space)).m[1];
    const int size = texels.width();
    double sum = 0.0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double cosine = equal_area_direction({(x + 0.5) / size, (y + 0.5) / size}).z;
            if (cosine <= 0.0) continue;
            const RGB& texel = texels(x, y);
            sum += cosine * (luminance[0] * static_cast<double>(texel.r) + luminance[1] * static_cast<double>(texel.g) +
                             luminance[2] * static_cast<double>(texel.b));
        }
    }
    return sum * 2.0 * std::numbers::pi / (static_cast<double>(size) * static_cast<double>(size));
}

/// Negative components to 0, as pbrt-v4 does. Returns how many texels had one.
std::size_t clamp_negative(Image<RGB>& texels) {
    std::size_t count = 0;
    for (RGB& texel : texels.pixels()) {
        if (texel.r >= 0.0f && texel.g >= 0.0f && texel.b >= 0.0f) continue;
        texel = {std::max(texel.r, 0.0f), std::max(texel.g, 0.0f), std::max(texel.b, 0.0f)};
        ++count;
    }
    return count;
}

float largest_component(const Image<RGB>& texels) noexcept {
    float largest = 0.0f;
    for (const RGB& texel : texels.pixels()) largest = std::max({largest, texel.r, texel.g, texel.b});
    return largest;
}

}  // namespace

Light read_image_light(const ParameterList& list, const LightContext& context) {
    const SceneParameter& file = *find_parameter(list, "filename");
    if (const SceneParameter* const spectrum = find_parameter(list, "L")) {
        throw SceneError(spectrum->place, R"(an "L" beside a "filename")", "one of the two");
    }
    ImageInfiniteLight light;
    light.world_from_light = rotation_of(context.world_from_object, list.place);
    RgbTexels picture = read_texels(file, context);
    if (!picture.note.empty()) {
        context.warnings.add(file.first_value,
                             fmt::format("picture {}: {}", quote(file.strings.front()), picture.note));
    }
    Image<RGB>& texels = picture.texels;
    if (texels.width() != texels.height()) {
        throw SceneError(file.first_value, fmt::format("a picture of {} x {} texels", texels.width(), texels.height()),
                         "a square one, of all directions in the equal-area mapping");
    }

    double luminance_cdm2 = real_or(list, "scale", 1.0);
    if (const double illuminance_lx = real_or(list, "illuminance", 0.0); illuminance_lx > 0.0) {
        const double illuminance = illuminance_of(texels, picture.space);
        if (!(illuminance > 0.0)) {
            throw SceneError(file.first_value, "a picture without light from above", "some, for an \"illuminance\"");
        }
        luminance_cdm2 *= illuminance_lx / illuminance;
    }
    if (const std::size_t count = clamp_negative(texels); count > 0) {
        context.warnings.add(file.first_value,
                             fmt::format("{} texels have a negative component, which is taken for 0", count));
    }

    // The picture's own space counts, whatever ColorSpace says.
    light.space = picture.space;
    light.illuminant = context.spectra.default_light(picture.space);
    light.illuminant.scale *= luminance_cdm2;
    ScaledSpectrum brightest = light.illuminant;
    brightest.scale *= std::max(1.0, 2.0 * static_cast<double>(largest_component(texels)));
    check_brightness(brightest, list.place);
    light.texels = std::make_shared<const Image<RGB>>(std::move(texels));
    return light;
}

}  // namespace emulsion
