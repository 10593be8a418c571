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
#include "spectrum/sampled_spectrum.h"
#include "spectrum/spectrum_table.h"

namespace emulsion {

/// One path from the camera on. Whoever starts it fills the first four.
template <int N>
struct Path {
    Ray ray;
    SampleSequence samples;
    SampledWavelengths<N> wavelengths;
    SpectrumTableIndex<N> index;  ///< of the wavelengths

    SampledSpectrum<N> throughput{1.0f};
    SampledSpectrum<N> radiance{0.0f};  ///< the result, W m^-2 sr^-1 nm^-1: an estimate at each wavelength
    float direction_pdf = 0.0f;         ///< per steradian, with which the last bounce drew the ray; 0 for the camera's
    Imath::V3f last_vertex{0.0f};       ///< where that was: the point for which the lights' densities were taken
};

/// Adds what a path has gathered around its place in the picture. Not inline, as that would cost the samples of other
/// films, which are added elsewhere.
template <int N>
void add_at(FilmTile& tile, float x_px, float y_px, const Path<N>& path) noexcept;

template <int N>
class PathIntegrator {
  public:
    /// `max_depth` >= 0: the longest path, in scattering events.
    PathIntegrator(const PreparedScene& scene, int max_depth) noexcept : scene_(scene), max_depth_(max_depth) {}

    /// Follows the paths to their ends and leaves what they gathered in their `radiance`. `first_hits`, unless it is
    /// empty, gets what each of them met first.
    void trace(std::span<Path<N>> paths, std::span<FirstHit> first_hits = {});

  private:
    struct ShadowRay {
        SampledSpectrum<N> radiance;  // what arrives through the path if nothing is in between
        std::uint32_t path;
    };

    void add_background(Path<N>& path) const noexcept;
    bool scatter(Path<N>& path, std::uint32_t path_index, const Hit& hit, int depth);
    void add_emission(Path<N>& path, const Emitter& emitter, const SurfacePoint& point, bool two_sided) const noexcept;
    void sample_light(Path<N>& path, std::uint32_t path_index, const SurfacePoint& point,
                      const SampledSpectrum<N>& reflectance, const Imath::V3f& facing_normal);
    void trace_shadow_rays(std::span<Path<N>> paths);

    const PreparedScene& scene_;
    int max_depth_;
    // Kept between calls for their capacity.
    std::vector<std::uint32_t> active_;
    std::vector<Ray> rays_, shadow_rays_;
    std::vector<Hit> hits_;
    std::vector<ShadowRay> shadows_;
    std::vector<std::uint8_t> occluded_;
};

extern template class PathIntegrator<1>;
extern template void add_at<1>(FilmTile&, float, float, const Path<1>&) noexcept;
extern template class PathIntegrator<2>;
extern template void add_at<2>(FilmTile&, float, float, const Path<2>&) noexcept;
extern template class PathIntegrator<4>;
extern template void add_at<4>(FilmTile&, float, float, const Path<4>&) noexcept;
extern template class PathIntegrator<8>;
extern template void add_at<8>(FilmTile&, float, float, const Path<8>&) noexcept;
extern template class PathIntegrator<16>;
extern template void add_at<16>(FilmTile&, float, float, const Path<16>&) noexcept;
extern template class PathIntegrator<32>;
extern template void add_at<32>(FilmTile&, float, float, const Path<32>&) noexcept;

}  // namespace emulsion
