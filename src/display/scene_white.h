#pragma once
// Whether colours are shown as they are, or as they looked in the light of the scene: adapted from the scene's white to
// the display's.

#include <array>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/matrix3.h"
#include "core/parameters.h"
#include "display/display.h"
#include "spectrum/chromatic_adaptation.h"

namespace emulsion {

/// XYZ of the scene is what the display shows.
struct AsItIs {
    static constexpr std::string_view kName = "none";
    static constexpr std::string_view kHelp = "no adaptation, colours are shown as they are";
    bool operator==(const AsItIs&) const = default;
};

/// The scene's white becomes the display's by one of the methods of spectrum/chromatic_adaptation.h.
template <class Method>
struct AdaptedBy {
    static constexpr std::string_view kName = Method::kName, kHelp = Method::kHelp;
    double x = 0.3127, y = 0.329;  ///< CIE 1931 chromaticity of the scene's white; by default D65
    bool operator==(const AdaptedBy&) const = default;

    static constexpr std::array kParameters = {
        Parameter<AdaptedBy>{"x", &AdaptedBy::x, {0.0, 1.0}, "", "of the scene's white, CIE 1931"},
        Parameter<AdaptedBy>{
            "y", &AdaptedBy::y, {0.0, 1.0, RangeEnd::open, RangeEnd::closed}, "", "of the scene's white, CIE 1931"}};
};

template <class Methods>
struct SceneWhiteOf;
template <class... Methods>
struct SceneWhiteOf<std::variant<Methods...>> {
    using Type = std::variant<AsItIs, AdaptedBy<Methods>...>;
};

/// No adaptation, the default, or any of the methods.
using SceneWhite = SceneWhiteOf<ChromaticAdaptation>::Type;

/// From XYZ in the scene's light to XYZ on the display; exactly the identity for none, and where the whites agree.
/// \throws std::invalid_argument as adaptation_matrix(): of a white that no light has.
[[nodiscard]] Matrix3 display_from_scene(const SceneWhite& white, const Display& display);

/// XYZ, Y = 1, of what the display shows as its white: the scene's white, without adaptation the display's.
/// \throws std::invalid_argument as xyz_of(): for y = 0.
[[nodiscard]] XYZd shown_as_white(const SceneWhite& white, const Display& display);

/// \throws std::invalid_argument naming method, parameter, value and range, or as display_from_scene().
void validate(const SceneWhite& white, const Display& display);

/// Of the white alone, whatever the display.
void validate(const SceneWhite& white);

}  // namespace emulsion
