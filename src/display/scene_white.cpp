#include "display/scene_white.h"

#include <stdexcept>

#include "core/named_value.h"

namespace emulsion {

namespace {

constexpr Matrix3 kIdentity = {{{{{1.0, 0.0, 0.0}}, {{0.0, 1.0, 0.0}}, {{0.0, 0.0, 1.0}}}}};

XYZd white_of(const AsItIs& /*white*/, const Display& display) { return white_xyz(display); }
template <class Method>
XYZd white_of(const AdaptedBy<Method>& white, const Display& /*display*/) {
    return xyz_of(Chromaticity{white.x, white.y});
}

Matrix3 matrix_of(const AsItIs& /*white*/, const Display& /*display*/) { return kIdentity; }
template <class Method>
Matrix3 matrix_of(const AdaptedBy<Method>& white, const Display& display) {
    return adaptation_matrix(Method{}, white_of(white, display), white_xyz(display));
}

}  // namespace

Matrix3 display_from_scene(const SceneWhite& white, const Display& display) {
    return std::visit([&](const auto& chosen) { return matrix_of(chosen, display); }, white);
}

XYZd shown_as_white(const SceneWhite& white, const Display& display) {
    return std::visit([&](const auto& chosen) { return white_of(chosen, display); }, white);
}

void validate(const SceneWhite& white, const Display& display) {
    validate_named(white, "scene-white");
    try {
        (void)display_from_scene(white, display);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("scene-white " + to_text(white) + ": " + error.what());
    }
}

void validate(const SceneWhite& white) { validate(white, Display{}); }

}  // namespace emulsion
