#pragma once
// Unidirectional spectral path tracing with next-event estimation, multiple importance sampling and Russian roulette,
// many paths at a time: each bounce of a batch is one call of Embree for the paths' rays and one for their shadow rays.
// Source: Kajiya, "The Rendering Equation", SIGGRAPH 1986; Veach & Guibas, SIGGRAPH 1995.

#include <cstdint>
#include <span>
#include <vector>

#include "film/film_tile.h"
#include "pathtracer/aux_layers.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/transport.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

/// One path from the camera on. Whoever starts it fills the first four.
template <class Transport>
struct Path {
    using Values = SampledSpectrum<Transport::kChannels>;

    Ray ray;
    SampleSequence samples;
    [[no_unique_address]] typename Transport::Wavelengths wavelengths;
    [[no_unique_address]] typename Transport::Index index;

    Values throughput{1.0f};
    Values radiance{0.0f};         ///< the result, in the transport's unit: an estimate for each channel
    float direction_pdf = 0.0f;    ///< per steradian, with which the last bounce drew the ray; 0: no light sample could
                                   ///< have found what it meets, as it comes from the camera or a smooth surface
    Imath::V3f last_vertex{0.0f};  ///< where that was: the point for which the lights' densities were taken
    float eta_scale = 1.0f;        ///< (eta of the medium that the path is in)^2, which its throughput is divided by
    Channels channels = Channels::all;
};

/// Adds what a path has gathered around its place in the picture. Not inline, as that would cost the samples of other
/// films, which are added elsewhere.
template <int N>
void add_at(FilmTile& tile, float x_px, float y_px, const Path<SpectralTransport<N>>& path) noexcept;

template <class Transport>
class PathIntegrator {
  public:
    using Values = SampledSpectrum<Transport::kChannels>;
    using PathT = Path<Transport>;

    /// `max_depth` >= 0: the longest path, in scattering events.
    PathIntegrator(const PreparedScene& scene, int max_depth) noexcept : scene_(scene), max_depth_(max_depth) {}

    /// Follows the paths to their ends and leaves what they gathered in their `radiance`. `first_hits`, unless it is
    /// empty, gets what each of them met first.
    void trace(std::span<PathT> paths, std::span<FirstHit> first_hits = {});

  private:
    struct ShadowRay {
        Values radiance;  // what arrives through the path if nothing is in between
        std::uint32_t path;
    };

    /// Where the path has met a surface.
    struct Vertex {
        const Hit& hit;
        const SurfacePoint& point;
        const TexturePoint& place;
    };

    void add_background(PathT& path) const noexcept;
    bool scatter(PathT& path, std::uint32_t path_index, const Hit& hit, int depth);
    void add_emission(PathT& path, const Emitter& emitter, const SurfacePoint& point, bool two_sided) const noexcept;
    bool scatter_material(PathT& path, std::uint32_t path_index, const PreparedMaterial& material, const Vertex& vertex,
                          int depth);
    template <class Evaluate>
    void sample_light(PathT& path, std::uint32_t path_index, const SurfacePoint& point, Evaluate&& evaluate);
    void trace_shadow_rays(std::span<PathT> paths);
    static bool survives_roulette(PathT& path, int depth) noexcept;

    const PreparedScene& scene_;
    int max_depth_;
    // Kept between calls for their capacity.
    std::vector<std::uint32_t> active_;
    std::vector<Ray> rays_, shadow_rays_;
    std::vector<Hit> hits_;
    std::vector<ShadowRay> shadows_;
    std::vector<std::uint8_t> occluded_;
};

#define EMULSION_DECLARE(TRANSPORT) extern template class PathIntegrator<TRANSPORT>;
EMULSION_FOR_EACH_TRANSPORT(EMULSION_DECLARE)
#undef EMULSION_DECLARE

}  // namespace emulsion
