#include "tonemap/vision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/named_value.h"
#include "tonemap/acuity.h"
#include "tonemap/copied.h"
#include "tonemap/pixel_class.h"
#include "tonemap/rod_vision.h"
#include "tonemap/veiling_glare.h"

namespace emulsion {

namespace {

/// Of the angle between neighbouring pixels at the centre of a perspective picture.
double tangent_per_px(const HumanVision& vision, ImageView<const XYZ> scene) noexcept {
    const double half_angle = double{vision.fov} * std::numbers::pi / 360.0;
    return 2.0 * std::tan(half_angle) / std::max(scene.width(), scene.height());
}

double degrees_per_px(const HumanVision& vision, ImageView<const XYZ> scene) noexcept {
    return tangent_per_px(vision, scene) * 180.0 / std::numbers::pi;
}

Image<XYZ> seen(const NoVision&, ImageView<const XYZ> scene, int threads) { return copied(scene, threads); }

Image<XYZ> seen(const HumanVision& vision, ImageView<const XYZ> scene, int threads) {
    Image<XYZ> picture =
        vision.glare > 0.0f ? add_veil(scene, double{vision.glare} * kVeilShare, tangent_per_px(vision, scene), threads)
                            : copied(scene, threads);
    if (vision.acuity > 0.0f) {
        lose_acuity(picture.view(), {vision.acuity, degrees_per_px(vision, scene)}, threads);
    }
    if (vision.rods > 0.0f) see_with_rods(picture.view(), {vision.rods, vision.blue}, threads);
    return picture;
}

}  // namespace

Image<XYZ> see(const Vision& vision, ImageView<const XYZ> scene, int threads) {
    validate_named(vision, "vision");
    return std::visit([&](const auto& chosen) { return seen(chosen, scene, threads); }, vision);
}

Image<XYZd> see_reference(const Vision& vision, ImageView<const XYZ> scene) {
    validate_named(vision, "vision");
    const HumanVision* human = std::get_if<HumanVision>(&vision);
    const HumanVision parts = human != nullptr ? *human : HumanVision{.glare = 0.0f, .acuity = 0.0f, .rods = 0.0f};
    Image<XYZd> picture = add_veil_reference(scene, double{parts.glare} * kVeilShare, tangent_per_px(parts, scene));
    if (parts.acuity > 0.0f) {
        picture = lose_acuity_reference(picture, scene, {parts.acuity, degrees_per_px(parts, scene)});
    }
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            if (is_bad(classify(scene(x, y)))) continue;
            picture(x, y) = seen_with_rods(picture(x, y), {parts.rods, parts.blue});
        }
    }
    return picture;
}

}  // namespace emulsion
