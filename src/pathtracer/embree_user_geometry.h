#pragma once
// Shapes that Embree does not know, or not exactly enough: it asks back where rays meet them.

#include "pathtracer/embree.h"
#include "pathtracer/quadrics.h"
#include "pathtracer/scene_geometry.h"

namespace emulsion {

/// Geometry of the device, not yet committed, with one primitive for each patch. The mesh must outlive it and stay
/// where it is.
[[nodiscard]] RTCGeometry user_geometry(RTCDevice device, const BilinearMesh& mesh);
/// The same with one primitive.
[[nodiscard]] RTCGeometry user_geometry(RTCDevice device, const PreparedQuadric& quadric);

}  // namespace emulsion
