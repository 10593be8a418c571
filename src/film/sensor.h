#pragma once
// The sensor: from the radiance at the wavelengths of one path to absolute XYZ.
// Radiance in W m^-2 sr^-1 nm^-1, wavelengths in nm, densities in 1/nm, Y in cd/m^2 (times the imaging ratio).

#include <array>
#include <cstddef>
#include <vector>

#include "core/color.h"
#include "core/units.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

/// The CIE 1931 2 degree observer behind a shutter: XYZ = 683 lm/W * imaging_ratio * integral L(lambda) xyzbar(lambda).
/// Between whole nanometres the colour-matching functions are straight lines.
class Sensor {
  public:
    /// imaging_ratio: exposure time in seconds * ISO / 100; 1 leaves Y in cd/m^2. Finite, > 0.
    /// \throws std::invalid_argument if it is not.
    explicit Sensor(double imaging_ratio = 1.0);

    /// 683 imaging_ratio / N * sum_i radiance_i / pdf_i * xyzbar(lambda_i): an unbiased estimate of XYZ if the
    /// wavelengths were drawn with those densities. Single precision: agrees with to_xyz_reference() to 4e-6 of the sum
    /// of the terms' absolute values.
    template <int N>
    [[nodiscard]] XYZ to_xyz(const SampledWavelengths<N>& wavelengths,
                             const SampledSpectrum<N>& radiance) const noexcept {
        constexpr int kLastCell = kMaxWavelength_nm - kMinWavelength_nm - 1;
        alignas(16) std::array<float, 4> sum{};
        for (std::size_t i = 0; i < N; ++i) {
            const float above = wavelengths.lambda_nm[i] - static_cast<float>(kMinWavelength_nm);
            int cell = static_cast<int>(above);
            cell = cell < 0 ? 0 : cell > kLastCell ? kLastCell : cell;
            const float fraction = above - static_cast<float>(cell);
            const float scaled = radiance.value[i] / wavelengths.pdf[i];
            const Lines& lines = lines_[static_cast<std::size_t>(cell)];
            for (std::size_t k = 0; k < 4; ++k) sum[k] += scaled * (lines.start[k] + fraction * lines.slope[k]);
        }
        constexpr float kPerWavelength = 1.0f / static_cast<float>(N);
        return {sum[0] * kPerWavelength, sum[1] * kPerWavelength, sum[2] * kPerWavelength};
    }

    /// The same in double precision.
    template <int N>
    [[nodiscard]] XYZd to_xyz_reference(const SampledWavelengths<N>& wavelengths,
                                        const SampledSpectrum<N>& radiance) const noexcept {
        XYZd sum;
        for (std::size_t i = 0; i < N; ++i) {
            const double scaled = static_cast<double>(radiance.value[i]) / static_cast<double>(wavelengths.pdf[i]);
            sum = sum + scaled * response(static_cast<double>(wavelengths.lambda_nm[i]));
        }
        return (1.0 / N) * sum;
    }

    /// 683 imaging_ratio xyzbar(lambda), lm/W, in double precision; 0 outside [kMinWavelength_nm, kMaxWavelength_nm].
    [[nodiscard]] XYZd response(double lambda_nm) const noexcept;
    [[nodiscard]] double imaging_ratio() const noexcept { return imaging_ratio_; }

  private:
    // x, y and z of one nanometre, and an idle fourth, so that a line is two vector registers and half a cache line.
    struct alignas(32) Lines {
        std::array<float, 4> start{}, slope{};
    };

    double imaging_ratio_;
    std::vector<XYZd> response_;  // at whole nanometres
    std::vector<Lines> lines_;    // by nanometre
};

}  // namespace emulsion
