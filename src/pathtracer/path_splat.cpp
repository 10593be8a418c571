// Apart from the integrator, whose file is as long as the compiler inlines well.

#include "pathtracer/channel_counts.h"
#include "pathtracer/path_integrator.h"

namespace emulsion {

template <int N>
void add_at(FilmTile& tile, float x_px, float y_px, const Path<SpectralTransport<N>>& path) noexcept {
    tile.add_at(x_px, y_px, path.wavelengths, path.radiance);
}

#define EMULSION_INSTANTIATE(N) \
    template void add_at<N>(FilmTile&, float, float, const Path<SpectralTransport<(N)>>&) noexcept;
EMULSION_FOR_EACH_WAVELENGTH_COUNT(EMULSION_INSTANTIATE)

}  // namespace emulsion
