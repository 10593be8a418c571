#include "pathtracer/scene_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "pathtracer/scene_transform.h"
#include "spectrum/spectrum_table.h"

namespace emulsion {

namespace {

constexpr double kPi = std::numbers::pi;

/// \throws SceneError if the light is too bright, at some wavelength, for the renderer's single precision.
void check_brightness(const ScaledSpectrum& light, const SourcePlace& place) {
    try {
        static_cast<void>(SpectrumTable(light.spectrum, light.scale));  // that is what the renderer will do
    } catch (const std::invalid_argument&) {
        throw SceneError(place, fmt::format("a light scaled by {:g}", light.scale), "one that single precision holds");
    }
}

/// The list's spectrum `name`, or the default, brought to a photometric value.
ScaledSpectrum scaled_light(const ParameterList& list, std::string_view name, double photometric_value,
                            SpectrumReader& spectra) {
    const SceneParameter* const parameter = find_parameter(list, name);
    ScaledSpectrum light = parameter == nullptr ? spectra.default_light(list.color_space) : spectra.light(*parameter);
    light.scale *= photometric_value;
    check_brightness(light, list.place);
    return light;
}

Light read_point_light(const ParameterList& list, const Imath::M44d& ctm, SpectrumReader& spectra) {
    double intensity_cd = real_or(list, "scale", 1.0);
    if (find_parameter(list, "power") != nullptr) intensity_cd *= real_or(list, "power", 0.0) / (4.0 * kPi);
    const Imath::V3d from = point_or(list, "from", Imath::V3d(0.0));
    const Imath::V3d position = transform_point(ctm, from);
    if (!is_within_reach(position)) {
        throw SceneError(list.place, fmt::format("a light at ({:g}, {:g}, {:g})", position.x, position.y, position.z),
                         std::string(kWithinReach));
    }
    return PointLight{position, scaled_light(list, "I", intensity_cd, spectra)};
}

Light read_distant_light(const ParameterList& list, const Imath::M44d& ctm, SpectrumReader& spectra) {
    const double illuminance_lx = real_or(list, "scale", 1.0) * real_or(list, "illuminance", 1.0);
    const Imath::V3d from = point_or(list, "from", Imath::V3d(0.0));
    const Imath::V3d to = point_or(list, "to", Imath::V3d(0.0, 0.0, 1.0));
    const Imath::V3d to_light = transform_vector(ctm, from - to);
    const double length = to_light.length();
    if (!(length > 0.0) || !std::isfinite(length)) {
        throw SceneError(list.place, R"(a distant light whose "from" and "to" give no direction)",
                         "two points apart from each other");
    }
    return DistantLight{to_light / length, scaled_light(list, "L", illuminance_lx, spectra)};
}

Light read_infinite_light(const ParameterList& list, const Imath::M44d&, SpectrumReader& spectra) {
    double luminance_cdm2 = real_or(list, "scale", 1.0);
    if (find_parameter(list, "illuminance") != nullptr) luminance_cdm2 *= real_or(list, "illuminance", 0.0) / kPi;
    return UniformInfiniteLight{scaled_light(list, "L", luminance_cdm2, spectra)};
}

struct LightReader {
    std::string_view name;
    Light (*read)(const ParameterList&, const Imath::M44d&, SpectrumReader&);
};
constexpr auto kReaders = std::to_array<LightReader>(
    {{"point", read_point_light}, {"distant", read_distant_light}, {"infinite", read_infinite_light}});

}  // namespace

Light read_light(const ParameterList& list, const Imath::M44d& world_from_object, SpectrumReader& spectra) {
    check_parameters(light_table(), list);
    return supported_row<LightReader>(list.place, {"light source"}, list.owner, kReaders)
        .read(list, world_from_object, spectra);
}

AreaLightSource read_area_light(const ParameterList& list, SpectrumReader& spectra) {
    check_parameters(area_light_table(), list);
    AreaLightSource source;
    source.radiance = scaled_light(list, "L", real_or(list, "scale", 1.0), spectra);
    if (find_parameter(list, "power") != nullptr) source.power_lm = real_or(list, "power", 0.0);
    source.two_sided = flag_or(list, "twosided", Flag::off) == Flag::on;
    source.place = list.place;
    return source;
}

AreaLight light_of_shape(const AreaLightSource& source, std::span<const double> light_areas) {
    AreaLight light{source.radiance, source.two_sided, {}};
    if (!source.power_lm) return light;
    // The first light sets the radiance, the others have theirs relative to it.
    const double first_area = light_areas.front();
    light.radiance.scale *= *source.power_lm / (kPi * first_area * (source.two_sided ? 2.0 : 1.0));
    ScaledSpectrum brightest = light.radiance;
    for (const double area : light_areas) {
        light.triangle_scale.push_back(static_cast<float>(first_area / area));
        brightest.scale = std::max(brightest.scale, light.radiance.scale * first_area / area);
    }
    check_brightness(brightest, source.place);
    return light;
}

}  // namespace emulsion
