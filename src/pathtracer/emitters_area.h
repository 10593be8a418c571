#pragma once
// Shapes as lights: drawing a direction towards one, and the density with which that is done.

#include <array>
#include <cstdint>

#include "pathtracer/emitter_sample.h"
#include "pathtracer/quadrics.h"
#include "pathtracer/scene_geometry.h"
#include "pathtracer/surface.h"

namespace emulsion {

/// Emits from one triangle of a mesh, to the side of the normal or to both. The mesh must outlive it.
struct TriangleEmitter {
    const TriangleMesh* mesh = nullptr;
    std::uint32_t triangle = 0;
    bool two_sided = false;
    float large_within2 = 0.0f;  ///< squared distance of the centre, beyond which it is surely seen as a small one
    Imath::V3f centre{0.0f};
    TriangleFace face;
};
/// Of one side.
[[nodiscard]] TriangleEmitter emitter_of(const TriangleMesh& mesh, std::uint32_t triangle) noexcept;

/// The same of one bilinear patch.
struct PatchEmitter {
    const BilinearMesh* mesh = nullptr;
    std::uint32_t patch = 0;
    bool two_sided = false;
};

/// The same of a sphere, disk or cylinder.
struct QuadricEmitter {
    const PreparedQuadric* quadric = nullptr;
    bool two_sided = false;
};

/// As sample() and direction_pdf() in emitters.h.
[[nodiscard]] EmitterSample sample_one(const TriangleEmitter& emitter, const Imath::V3f& from,
                                       std::array<float, 2> u) noexcept;
[[nodiscard]] EmitterSample sample_one(const PatchEmitter& emitter, const Imath::V3f& from,
                                       std::array<float, 2> u) noexcept;
[[nodiscard]] EmitterSample sample_one(const QuadricEmitter& emitter, const Imath::V3f& from,
                                       std::array<float, 2> u) noexcept;
[[nodiscard]] float pdf_of(const TriangleEmitter& emitter, const MetEmitter& met) noexcept;
[[nodiscard]] float pdf_of(const PatchEmitter& emitter, const MetEmitter& met) noexcept;
[[nodiscard]] float pdf_of(const QuadricEmitter& emitter, const MetEmitter& met) noexcept;

}  // namespace emulsion
