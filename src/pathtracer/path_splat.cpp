// Apart from the integrator, whose file is as long as the compiler inlines well.

#include "pathtracer/path_integrator.h"

namespace emulsion {

template <int N>
void add_at(FilmTile& tile, float x_px, float y_px, const Path<N>& path) noexcept {
    tile.add_at(x_px, y_px, path.wavelengths, path.radiance);
}

template void add_at<1>(FilmTile&, float, float, const Path<1>&) noexcept;
template void add_at<2>(FilmTile&, float, float, const Path<2>&) noexcept;
template void add_at<4>(FilmTile&, float, float, const Path<4>&) noexcept;
template void add_at<8>(FilmTile&, float, float, const Path<8>&) noexcept;
template void add_at<16>(FilmTile&, float, float, const Path<16>&) noexcept;
template void add_at<32>(FilmTile&, float, float, const Path<32>&) noexcept;

}  // namespace emulsion
