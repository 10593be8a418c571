#pragma once
// A picture of the light from everywhere, made ready for rendering: radiance and density by direction. Texels are not
// filtered, as in pbrt-v4, so that both are constant in each, and exact for multiple importance sampling.

#include <array>
#include <memory>

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "pathtracer/scene_light.h"
#include "pathtracer/texel_colours.h"
#include "pathtracer/texel_distribution.h"
#include "pathtracer/transport.h"

namespace emulsion {

class EnvironmentMap {
  public:
    explicit EnvironmentMap(const ImageInfiniteLight& light);

    /// For paths of these channels. `illuminant` is the light's own.
    /// \throws std::invalid_argument as SpectrumTables::prepare().
    void prepare(const FixedChannels& channels, const Spectrum& illuminant) { colours_.prepare(channels, illuminant); }

    /// A direction towards the light, drawn with density pdf(): texels by how much brighter they are than the mean, as
    /// what is no brighter is found well enough by the surfaces' own sampling.
    /// Source: Karlik et al., "MIS Compensation: Optimizing Sampling Techniques in Multiple Importance Sampling",
    /// SIGGRAPH Asia 2019; as pbrt-v4 has it, a thousandth of the mean is left to the others.
    [[nodiscard]] Imath::V3f sample(std::array<float, 2> u) const noexcept;

    /// Per steradian, of a unit vector in world space.
    [[nodiscard]] float pdf(const Imath::V3f& direction) const noexcept;

    /// What the light's illuminant is to be multiplied by to have the radiance from a direction.
    template <class Index>
    [[nodiscard]] ValuesAt<Index> colour(const Imath::V3f& direction, const Index& index) const noexcept;

  private:
    struct Texel {
        int x, y;
    };
    [[nodiscard]] Texel texel_of(const Imath::V3f& direction) const noexcept;

    std::shared_ptr<const Image<RGB>> texels_;
    Imath::M33d light_from_world_, world_from_light_;
    TexelDistribution distribution_;
    TexelColours colours_;
};

/// The luminance that the mean texel gives an illuminant of luminance 1.
[[nodiscard]] double mean_luminance(const Image<RGB>& texels, ColorSpace space);

}  // namespace emulsion
