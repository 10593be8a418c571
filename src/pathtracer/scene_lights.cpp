#include "pathtracer/scene_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "pathtracer/light_powers.h"
#include "pathtracer/scene_image_light.h"
#include "pathtracer/scene_transform.h"
#include "spectrum/spectrum_table.h"

namespace emulsion {

namespace {

constexpr double kPi = std::numbers::pi;

/// The list's spectrum `name`, or the default, brought to a photometric value.
ScaledSpectrum scaled_light(const ParameterList& list, std::string_view name, double photometric_value,
                            SpectrumReader& spectra) {
    const SceneParameter* const parameter = find_parameter(list, name);
    ScaledSpectrum light = parameter == nullptr ? spectra.default_light(list.color_space) : spectra.light(*parameter);
    light.scale *= photometric_value;
    check_brightness(light, list.place);
    return light;
}

/// A factor that is only there if it is above 0, as in pbrt-v4.
std::optional<double> given_above_0(const ParameterList& list, std::string_view name) {
    const double value = real_or(list, name, 0.0);
    return value > 0.0 ? std::optional(value) : std::nullopt;
}

Imath::V3d position_of(const ParameterList& list, const LightContext& context) {
    const Imath::V3d from = point_or(list, "from", Imath::V3d(0.0));
    const Imath::V3d position = transform_point(context.world_from_object, from);
    if (!is_within_reach(position)) {
        throw SceneError(list.place, fmt::format("a light at ({:g}, {:g}, {:g})", position.x, position.y, position.z),
                         std::string(kWithinReach));
    }
    return position;
}

Light read_point_light(const ParameterList& list, const LightContext& context) {
    double intensity_cd = real_or(list, "scale", 1.0);
    if (const auto power_lm = given_above_0(list, "power")) intensity_cd *= *power_lm / (4.0 * kPi);
    return PointLight{position_of(list, context), scaled_light(list, "I", intensity_cd, context.spectra)};
}

/// Directions of the world to those of a space whose +z is object space's from `from` to `to`. pbrt-v4 has the falloff
/// of a spot in its own space: under a map that stretches, its cone is none in the world.
Imath::M44d light_from_world(const ParameterList& list, const LightContext& context) {
    const Imath::V3d from = point_or(list, "from", Imath::V3d(0.0));
    const Imath::V3d axis = point_or(list, "to", Imath::V3d(0.0, 0.0, 1.0)) - from;
    const double length = axis.length();
    if (!(length > 0.0) || !std::isfinite(length)) {
        throw SceneError(list.place, R"(a spot light whose "from" and "to" give no direction)",
                         "two points apart from each other");
    }
    const Imath::V3d z = axis / length;
    const Imath::V3d x = (std::abs(z.x) < 0.5 ? Imath::V3d(1, 0, 0) : Imath::V3d(0, 1, 0)).cross(z).normalized();
    const Imath::V3d y = z.cross(x);
    const Imath::M44d object_from_light(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, 0, 0, 0, 1);
    const std::optional<Imath::M44d> inverse = inverse_of(object_from_light * context.world_from_object);
    if (!inverse) {
        throw SceneError(list.place, "a spot light in a space that can't be reached",
                         "a transformation that double precision can undo");
    }
    // Directions only, and of no matter how long: brought to a size that single precision holds.
    Imath::M44d directions = *inverse;
    double largest = 0.0;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) largest = std::max(largest, std::abs(directions[row][column]));
    }
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column) directions[row][column] *= row < 3 ? 1.0 / largest : 0.0;
    }
    return directions;
}

Light read_spot_light(const ParameterList& list, const LightContext& context) {
    const double cone_deg = real_or(list, "coneangle", 30.0), delta_deg = real_or(list, "conedeltaangle", 5.0);
    if (cone_deg > 180.0) {
        throw SceneError(find_parameter(list, "coneangle")->first_value, fmt::format("a cone of {} degrees", cone_deg),
                         "at most 180 from the axis");
    }
    // As pbrt-v4 has it, an angle below 0, where the light would start to fade, is as good as one above.
    if (delta_deg > 2.0 * cone_deg) {
        throw SceneError(list.place, fmt::format("a cone of {} degrees that fades over {}", cone_deg, delta_deg),
                         "a conedeltaangle of at most twice the coneangle: pbrt-v4 turns the cone inside out");
    }
    SpotLight light;
    light.position = position_of(list, context);
    light.light_from_world = light_from_world(list, context);
    light.cos_none = std::cos(cone_deg * kPi / 180.0);
    light.cos_full = std::cos((cone_deg - delta_deg) * kPi / 180.0);
    double intensity_cd = real_or(list, "scale", 1.0);
    if (const auto power_lm = given_above_0(list, "power")) {
        intensity_cd *= *power_lm / spot_solid_angle(light.cos_full, light.cos_none);
    }
    light.intensity = scaled_light(list, "I", intensity_cd, context.spectra);
    return light;
}

Light read_distant_light(const ParameterList& list, const LightContext& context) {
    const double illuminance_lx = real_or(list, "scale", 1.0) * given_above_0(list, "illuminance").value_or(1.0);
    const Imath::V3d from = point_or(list, "from", Imath::V3d(0.0));
    const Imath::V3d to = point_or(list, "to", Imath::V3d(0.0, 0.0, 1.0));
    const Imath::V3d to_light = transform_vector(context.world_from_object, from - to);
    const double length = to_light.length();
    if (!(length > 0.0) || !std::isfinite(length)) {
        throw SceneError(list.place, R"(a distant light whose "from" and "to" give no direction)",
                         "two points apart from each other");
    }
    return DistantLight{to_light / length, scaled_light(list, "L", illuminance_lx, context.spectra)};
}

Light read_infinite_light(const ParameterList& list, const LightContext& context) {
    if (find_parameter(list, "filename") != nullptr) return read_image_light(list, context);
    double luminance_cdm2 = real_or(list, "scale", 1.0);
    if (const auto illuminance_lx = given_above_0(list, "illuminance")) luminance_cdm2 *= *illuminance_lx / kPi;
    return UniformInfiniteLight{scaled_light(list, "L", luminance_cdm2, context.spectra)};
}

struct LightReader {
    std::string_view name;
    Light (*read)(const ParameterList&, const LightContext&);
};
constexpr auto kReaders = std::to_array<LightReader>({{"point", read_point_light},
                                                      {"spot", read_spot_light},
                                                      {"distant", read_distant_light},
                                                      {"infinite", read_infinite_light}});

}  // namespace

void check_brightness(const ScaledSpectrum& light, const SourcePlace& place) {
    try {
        static_cast<void>(SpectrumTable(light.spectrum, light.scale));  // that is what the renderer will do
    } catch (const std::invalid_argument&) {
        throw SceneError(place, fmt::format("a light scaled by {:g}", light.scale), "one that single precision holds");
    }
}

Light read_light(const ParameterList& list, const LightContext& context) {
    check_parameters(light_table(), list);
    return supported_row<LightReader>(list.place, {"light source"}, list.owner, kReaders).read(list, context);
}

AreaLightSource read_area_light(const ParameterList& list, SpectrumReader& spectra) {
    check_parameters(area_light_table(), list);
    AreaLightSource source;
    source.radiance = scaled_light(list, "L", real_or(list, "scale", 1.0), spectra);
    source.power_lm = given_above_0(list, "power");
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
