#pragma once
// Light sources as next-event estimation sees them: draw a direction towards one, and say with what density.

#include <array>
#include <cstdint>
#include <numbers>
#include <variant>
#include <vector>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "pathtracer/emitter_sample.h"
#include "pathtracer/emitters_area.h"

namespace emulsion {

class EnvironmentMap;

/// An intensity at a point: irradiance falls with the squared distance.
struct PointEmitter {
    Imath::V3f position;
};

/// The same within a cone: see SpotLight.
struct SpotEmitter {
    Imath::V3f position;
    Imath::M33f light_from_world;
    float cos_full = 1.0f, cos_none = 0.0f;
};

struct DistantEmitter {
    Imath::V3f to_light;  ///< unit vector
};

/// The same radiance from everywhere.
struct InfiniteEmitter {};

/// Radiance from everywhere by a picture; outlived by it.
struct ImageEmitter {
    const EnvironmentMap* map = nullptr;
};

using EmitterGeometry = std::variant<TriangleEmitter, PatchEmitter, QuadricEmitter, PointEmitter, SpotEmitter,
                                     DistantEmitter, InfiniteEmitter, ImageEmitter>;

struct Emitter {
    EmitterGeometry geometry;
    std::uint32_t spectrum = 0;          ///< which table of the prepared scene; of pictures, that of the illuminant
    float scale = 1.0f;                  ///< of the spectrum
    float selection_probability = 0.0f;  ///< with which EmitterPicker picks it
};

/// Draws a direction from `from` towards the light, by two uniform numbers in [0, 1).
[[nodiscard]] EmitterSample sample(const EmitterGeometry& emitter, const Imath::V3f& from,
                                   std::array<float, 2> u) noexcept;

/// Density per steradian with which sample() draws, for the point `from`, the unit `direction` in which this emitter
/// was met at `point`, where its surface has the unit `normal`.
[[nodiscard]] float direction_pdf(const EmitterGeometry& emitter, const Imath::V3f& from, const Imath::V3f& direction,
                                  const Imath::V3f& point, const Imath::V3f& normal) noexcept;

/// Density of any direction towards an infinite emitter.
inline constexpr float kInfiniteEmitterPdf = 0.25f * std::numbers::inv_pi_v<float>;

/// Picks emitters with given probabilities, in constant time.
/// Source: Walker, "An Efficient Method for Generating Discrete Random Variables", ACM TOMS 3(3), 1977; the tables as
/// built by Vose (1991).
class EmitterPicker {
  public:
    EmitterPicker() = default;
    /// Weights are finite and >= 0, and their sum is positive.
    explicit EmitterPicker(const std::vector<double>& weights);

    /// u in [0, 1) to an index. The bits of u are shared between the cell and the threshold in it: among many
    /// emitters a single-precision u has too few, and the probabilities would not be those promised.
    [[nodiscard]] std::uint32_t pick(double u) const noexcept {
        const double scaled = u * static_cast<double>(cells_.size());
        const auto i = std::min(static_cast<std::uint32_t>(scaled), static_cast<std::uint32_t>(cells_.size() - 1));
        return scaled - static_cast<double>(i) < cells_[i].threshold ? i : cells_[i].alias;
    }

  private:
    struct Cell {
        double threshold = 1.0;
        std::uint32_t alias = 0;
    };
    std::vector<Cell> cells_;
};

}  // namespace emulsion
