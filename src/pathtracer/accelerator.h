#pragma once
// Which shape does a ray meet first, and does it meet any: Embree behind plain rays and hits.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <Imath/ImathVec.h>

#include "pathtracer/scene.h"
#include "pathtracer/scene_objects.h"

namespace emulsion {

/// The points origin + t direction with 0 < t < t_max. The direction need not be of unit length.
struct Ray {
    Imath::V3f origin;
    Imath::V3f direction;
    float t_max = std::numeric_limits<float>::infinity();
};

/// The first point that a ray meets.
struct Hit {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    float t = 0.0f;  ///< along the ray, in lengths of its direction
    /// On a triangle: p0 + u (p1 - p0) + v (p2 - p0). On a patch its (u, v), or if the mesh is flat those of Embree's
    /// quadrilateral (see surface.cpp).
    float u = 0.0f, v = 0.0f;
    std::uint32_t shape = kNone;     ///< index into Scene::shapes, or kNone: nothing was met
    std::uint32_t primitive = 0;     ///< the triangle or patch of a mesh
    std::uint32_t instance = kNone;  ///< index into Scene::instances, or kNone: the shape belongs to no object
};

/// Every ray that was traced, batch by batch: for replaying them through Embree alone.
struct RayLog {
    struct Batch {
        std::vector<Ray> rays;
        enum class Query { intersect, occluded } query;
    };
    std::vector<Batch> batches;
};

/// Of two hierarchies over the same shapes the compact one takes half of the memory, and a seventh more of the
/// rendering time (docs/geometry.md).
enum class Hierarchy { fast, compact };

/// Triangles of a scene from which on its hierarchies are compact.
inline constexpr std::size_t kManyTriangles = 4'000'000;

class Accelerator {
  public:
    /// Builds Embree's hierarchy over the scene's shapes and instances on up to `threads` threads (0: all): a compact
    /// one from `many_triangles` on. `objects` are those of settle_objects(). The shapes must outlive it, and stay
    /// where they are. \throws std::runtime_error if that fails: with Embree's reason, or because coordinates are
    /// beyond its range.
    Accelerator(const Scene& scene, std::span<const ShapeRange> objects, int threads,
                std::size_t many_triangles = kManyTriangles);
    ~Accelerator();
    Accelerator(const Accelerator&) = delete;
    Accelerator& operator=(const Accelerator&) = delete;

    /// hits[i] = the first hit of rays[i]; both of the same size. Neighbours in the span are traced together.
    void intersect(std::span<const Ray> rays, std::span<Hit> hits) const;

    /// occluded[i] = 1 if rays[i] meets anything, else 0.
    void occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const;

    /// From now on every query is also written to `log` (one thread only); nullptr ends it.
    void record(RayLog* log) noexcept { log_ = log; }

    [[nodiscard]] Hierarchy hierarchy() const noexcept { return hierarchy_; }

    /// Half the diagonal of the bounding box of all that can be seen; 0 if there is nothing.
    [[nodiscard]] float bounds_radius() const noexcept { return bounds_radius_; }

  private:
    struct Embree;
    std::unique_ptr<Embree> embree_;
    Hierarchy hierarchy_ = Hierarchy::fast;
    float bounds_radius_ = 0.0f;
    RayLog* log_ = nullptr;
};

}  // namespace emulsion
