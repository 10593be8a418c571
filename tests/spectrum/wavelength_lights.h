#pragma once
// What the tests of wavelength sampling estimate: lights with and without delta lines on a reflector, and their XYZ.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/observer.h"
#include "spectrum/wavelength_importance.h"
#include "spectrum/wavelength_lines.h"

namespace emulsion {

/// A reflector under a light; relative.
struct LitReflector {
    std::string name;
    Spectrum continuum;
    std::vector<Line> lines;
    Spectrum reflectance;
};

inline LitReflector lit_by(const char* illuminant, const Spectrum& reflectance = ConstantSpectrum{1.0}) {
    return {illuminant, tabulated_spectrum("illuminants_5nm", illuminant), {}, reflectance};
}

/// Lines of mercury on the continuum of a lamp: 29% of its X + Y + Z.
inline LitReflector lit_by_lines(const Spectrum& reflectance = ConstantSpectrum{1.0}) {
    return {"lines", BlackbodySpectrum{3000.0}, {{435.833, 6.0}, {546.074, 12.0}, {578.013, 9.0}}, reflectance};
}

/// A green of no particular table: smooth, and far from constant.
inline Spectrum green_reflectance() { return SigmoidSpectrum{{-40.0, 30.0, -5.0}}; }

inline WavelengthImportance importance_of(const LitReflector& lit) {
    return wavelength_importance(sum_of(lit.continuum, LineSpectrum{lit.lines, {}}));
}

/// The integrals over the observer, without 683.
inline XYZd exact_xyz(const LitReflector& lit) {
    const double white = photometric_integral(lit.continuum);
    XYZd xyz = white * xyz_of_reflectance(lit.reflectance, lit.continuum);
    for (const Line& line : lit.lines) {
        xyz = xyz + line.power * eval(lit.reflectance, line.lambda_nm) * eval(cie_1931_2deg(), line.lambda_nm);
    }
    return xyz;
}

/// The estimate of a film, in double precision: what wavelength_lines.h says of renderers.
template <int N>
XYZd estimated_xyz(const LitReflector& lit, const SampledLineWavelengths<N>& wavelengths) {
    XYZd sum;
    for (std::size_t i = 0; i < N; ++i) {
        const auto lambda_nm = static_cast<double>(wavelengths.lambda_nm[i]);
        const std::int32_t line = wavelengths.line[i];
        const double light =
            line == kNoLine ? eval(lit.continuum, lambda_nm) : lit.lines[static_cast<std::size_t>(line)].power;
        const double radiance = light * eval(lit.reflectance, lambda_nm);
        sum = sum + radiance / static_cast<double>(wavelengths.pdf[i]) * eval(cie_1931_2deg(), lambda_nm);
    }
    return (1.0 / N) * sum;
}

/// Mean and spread of estimates.
struct Moments {
    std::array<double, 3> sum{}, square{};
    int count = 0;

    void add(const XYZd& xyz) {
        const std::array<double, 3> value = {xyz.x, xyz.y, xyz.z};
        for (std::size_t c = 0; c < 3; ++c) {
            sum[c] += value[c];
            square[c] += value[c] * value[c];
        }
        ++count;
    }
    [[nodiscard]] double mean(std::size_t c) const { return sum[c] / count; }
    [[nodiscard]] double deviation(std::size_t c) const {
        return std::sqrt(std::max(0.0, square[c] / count - mean(c) * mean(c)));
    }
};

}  // namespace emulsion
