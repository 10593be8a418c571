#include "spectrum/cie_1964_uvw.h"

#include <cmath>

namespace emulsion {

Cie1964Uvw uvw_of(const Uv1960& uv, double luminance, const Uv1960& white) noexcept {
    const double w = 25.0 * std::cbrt(100.0 * luminance) - 17.0;
    return {13.0 * w * (uv.u - white.u), 13.0 * w * (uv.v - white.v), w};
}

Cie1964Uvw uvw_from_xyz(const XYZd& xyz, const XYZd& white) noexcept {
    const Uv1960 white_uv = uv_1960_of(white);
    return uvw_of(xyz == XYZd{} ? white_uv : uv_1960_of(xyz), xyz.y, white_uv);
}

XYZd xyz_from_uvw(const Cie1964Uvw& uvw, const XYZd& white) noexcept {
    const double root = (uvw.w + 17.0) / 25.0;
    const double luminance = root * root * root / 100.0;

    Uv1960 uv = uv_1960_of(white);
    if (uvw.u != 0.0 || uvw.v != 0.0) uv = {uv.u + uvw.u / (13.0 * uvw.w), uv.v + uvw.v / (13.0 * uvw.w)};

    // From u = 4X / s, v = 6Y / s with s = X + 15Y + 3Z.
    const double s = 6.0 * luminance / uv.v;
    const double x = 0.25 * uv.u * s;
    return {x, luminance, (s - x - 15.0 * luminance) / 3.0};
}

}  // namespace emulsion
