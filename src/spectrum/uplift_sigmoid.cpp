#include "spectrum/uplift_sigmoid.h"

#include <array>

#include "spectrum/sigmoid.h"
#include "spectrum/sigmoid_solver.h"

namespace emulsion {

namespace {

// Black and white have none but infinite coefficients, and so are solved for by themselves with the other greys.
bool is_grey(const RGBd& rgb) noexcept { return rgb.r == rgb.g && rgb.g == rgb.b; }

SigmoidSpectrum constant_sigmoid(double value) noexcept { return {{0.0, 0.0, inverse_sigmoid(value)}}; }

}  // namespace

SigmoidFit::SigmoidFit(const ReflectanceRgb& space)
    : xyz_weights_(space.xyz_weights), relative_xyz_from_rgb_(space.relative_xyz_from_rgb) {}

SigmoidSpectrum SigmoidFit::reflectance(const RGBd& rgb) const noexcept {
    if (is_grey(rgb)) return constant_sigmoid(rgb.r);
    const std::array<double, 3> xyz = relative_xyz_from_rgb_ * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
    return solve_sigmoid(xyz_weights_, {xyz[0], xyz[1], xyz[2]});
}

SigmoidSpectrum TabulatedSigmoid::reflectance(const RGBd& rgb) const noexcept {
    if (is_grey(rgb)) return constant_sigmoid(rgb.r);  // in double precision
    return sigmoid_of(
        table_.reflectance({static_cast<float>(rgb.r), static_cast<float>(rgb.g), static_cast<float>(rgb.b)}));
}

}  // namespace emulsion
