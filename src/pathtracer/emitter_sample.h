#pragma once
// What next-event estimation and its converse exchange with every kind of light.

#include <cmath>

#include <Imath/ImathVec.h>

namespace emulsion {

/// One way to light a point. The radiance that arrives, unless something is in between, is scale * spectrum.
struct EmitterSample {
    Imath::V3f to_light{0.0f};  ///< unit vector
    Imath::V3f target{0.0f};    ///< where the shadow ray ends; for infinitely far lights unused
    bool infinite = false;      ///< the shadow ray has no end
    float pdf = 0.0f;           ///< per steradian; 0: a light without extent, that no ray meets by chance
    float scale = 0.0f;         ///< 0: this point is not lit by this sample
};

/// What a ray has met.
struct MetEmitter {
    Imath::V3f from, direction;  ///< where the ray came from, and its unit direction
    Imath::V3f point, normal;    ///< where it met the light, and the light's unit normal there
};

}  // namespace emulsion
