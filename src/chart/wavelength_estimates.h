#pragma once
// How far an estimate of XYZ is off that has a few wavelengths of a path to go by.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/random.h"
#include "spectrum/colorimetry.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {

/// A light on a white reflector.
struct EstimatedLight {
    std::string name = {};
    Spectrum continuum = {};
    std::vector<Line> lines = {};
};

[[nodiscard]] inline WavelengthImportance importance_of(const EstimatedLight& light) {
    return wavelength_importance(sum_of(light.continuum, LineSpectrum{light.lines, {}}));
}

/// Relative, as estimates are: without the luminous efficacy.
[[nodiscard]] inline XYZd exact_xyz(const EstimatedLight& light) {
    XYZd xyz = (1.0 / kLuminousEfficacy) * xyz_of_radiance(light.continuum);
    for (const Line& line : light.lines) xyz = xyz + line.power * eval(cie_1931_2deg(), line.lambda_nm);
    return xyz;
}

/// From the wavelengths of one path, in double precision.
template <int N>
[[nodiscard]] XYZd estimate(const EstimatedLight& light, const SampledLineWavelengths<N>& wavelengths) {
    XYZd sum;
    for (std::size_t i = 0; i < N; ++i) {
        const auto lambda_nm = static_cast<double>(wavelengths.lambda_nm[i]);
        const std::int32_t line = wavelengths.line[i];
        const double radiance =
            line == kNoLine ? eval(light.continuum, lambda_nm) : light.lines[static_cast<std::size_t>(line)].power;
        sum = sum + radiance / static_cast<double>(wavelengths.pdf[i]) * eval(cie_1931_2deg(), lambda_nm);
    }
    return (1.0 / N) * sum;
}

/// Mean squares of the relative errors of X, Y and Z over some estimates.
template <int N>
[[nodiscard]] XYZd mean_squared_error(const WavelengthSampler& sampler, const EstimatedLight& light, const XYZd& exact,
                                      int estimates, Pcg32& random) {
    XYZd square;
    for (int i = 0; i < estimates; ++i) {
        const XYZd xyz = estimate<N>(light, sample_wavelengths<N>(sampler, [&] { return random.next_float(); }));
        const XYZd error = {xyz.x / exact.x - 1.0, xyz.y / exact.y - 1.0, xyz.z / exact.z - 1.0};
        square = square + XYZd{error.x * error.x, error.y * error.y, error.z * error.z};
    }
    return (1.0 / estimates) * square;
}

}  // namespace emulsion
