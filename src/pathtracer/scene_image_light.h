#pragma once
// LightSource "infinite" with a picture.

#include "pathtracer/scene_lights.h"

namespace emulsion {

/// The picture is a square in the equal-area mapping (equal_area.h), z of light space being its middle; other
/// projections are to be converted, by pbrt-v4's "imgtool makeequiarea" for one. A texel (1, 1, 1) is the illuminant of
/// the picture's space, D65 but for ACES, of the luminance `scale`, in cd/m^2, unless there is an `illuminance`: that
/// is then, times `scale`, what light space's upper half gives a surface that looks up, as pbrt-v4 reckons it: it has a
/// factor 2 pi over the number of texels where 4 pi would be right, so that there is twice as much light as asked for.
/// \throws SceneError if there is an "L" besides; for a picture that can't be read or is no square; for an illuminance
/// of a picture that has no light above; under a transformation that is more than a rotation, a mirror and a scale.
[[nodiscard]] Light read_image_light(const ParameterList& list, const LightContext& context);

}  // namespace emulsion
