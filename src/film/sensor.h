#pragma once
// The sensor: from the radiance at the wavelengths of one path to absolute XYZ.
// Radiance in W m^-2 sr^-1 nm^-1, wavelengths in nm, densities in 1/nm, Y in cd/m^2 times the imaging ratio.
//
// Whatever the options, a sensor is three functions of the wavelength: balance * M * curves * 683 * imaging ratio. All
// of that goes into one table, so that a camera, another observer or a white balance cost nothing at each sample.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "core/color.h"
#include "core/units.h"
#include "film/sensor_options.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

/// One path as a sensor sees it.
struct SensorSample {
    XYZ xyz;
    /// Luminance in cd/m^2 times the imaging ratio, as the observer sees it, neither through a camera nor balanced.
    /// Their functions have negative lobes: violet light may rightly have a negative xyz.y. This number is negative for
    /// negative radiance only.
    float luminance = 0.0f;
};

/// XYZ = 683 lm/W * imaging ratio * integral of L(lambda) times the responses: the observer's functions, or a camera's
/// curves times its matrix (CameraFit); then the white balance, if any. Between whole nanometres the responses are
/// straight lines; outside their tables they are 0, with a jump.
class Sensor {
  public:
    /// \throws std::invalid_argument as validate(SensorOptions) and fit_camera() do.
    explicit Sensor(const SensorOptions& options = {});

    /// 683 imaging_ratio / N * sum_i radiance_i / pdf_i * response(lambda_i): an unbiased estimate of XYZ if the
    /// wavelengths were drawn with those densities. Single precision: agrees with to_xyz_reference() to 4e-6 of the sum
    /// of all terms taken positive; that is 4e-6 of X + Y + Z for an observer and radiances of one sign.
    template <int N>
    [[nodiscard]] SensorSample sense(const SampledWavelengths<N>& wavelengths,
                                     const SampledSpectrum<N>& radiance) const noexcept {
        static_assert(N <= 4 || N % 4 == 0, "wavelengths are read in fours");
        Float4 sum{};
        for (int first = 0; first < N; first += 4) sum += sum_of_four(wavelengths, radiance, first);
        constexpr float kPerWavelength = 1.0f / static_cast<float>(N);
        sum *= kPerWavelength;
        return {{sum[0], sum[1], sum[2]}, sum[3]};
    }
    template <int N>
    [[nodiscard]] XYZ to_xyz(const SampledWavelengths<N>& wavelengths,
                             const SampledSpectrum<N>& radiance) const noexcept {
        return sense(wavelengths, radiance).xyz;
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

    /// 683 imaging_ratio times the responses, lm/W, in double precision; 0 outside [kMinWavelength_nm,
    /// kMaxWavelength_nm]. At a jump, the value above it.
    [[nodiscard]] XYZd response(double lambda_nm) const noexcept;
    /// 683 imaging_ratio ybar(lambda) of the observer, lm/W: what SensorSample::luminance is made with.
    [[nodiscard]] double luminance_response(double lambda_nm) const noexcept;

    [[nodiscard]] const SensorOptions& options() const noexcept { return options_; }
    [[nodiscard]] double imaging_ratio() const noexcept { return emulsion::imaging_ratio(options_); }
    /// How well the camera's curves could be brought to XYZ; unset without a camera.
    [[nodiscard]] const std::optional<CameraFit>& camera_fit() const noexcept { return camera_fit_; }

  private:
    // Four numbers in one vector register; a compiler's own vectorisation takes twice the time here.
    using Float4 [[gnu::vector_size(16)]] = float;
    using Int4 [[gnu::vector_size(16)]] = std::int32_t;

    // The responses x, y and z on one nanometre, and that to luminance: start + fraction * slope.
    struct Lines {
        Float4 start{}, slope{};
    };
    struct Response {
        XYZd xyz;
        double luminance = 0.0;
    };
    // Neighbours don't share their values: there may be a jump between them.
    struct Cell {
        Response start, end;
    };

    [[nodiscard]] Response at(double lambda_nm) const noexcept;

    /// The sum over wavelengths first ... first + 3; over all of them if N < 4.
    template <int N>
    [[nodiscard]] Float4 sum_of_four(const SampledWavelengths<N>& wavelengths, const SampledSpectrum<N>& radiance,
                                     int first) const noexcept {
        // Idle places get no radiance.
        constexpr float kMin_nm = kMinWavelength_nm;
        constexpr std::size_t kBytes = sizeof(float) * std::min(N, 4);
        Float4 lambda_nm = {kMin_nm, kMin_nm, kMin_nm, kMin_nm}, pdf = {1.0f, 1.0f, 1.0f, 1.0f}, value{};
        std::memcpy(&lambda_nm, wavelengths.lambda_nm.data() + first, kBytes);
        std::memcpy(&pdf, wavelengths.pdf.data() + first, kBytes);
        std::memcpy(&value, radiance.value.data() + first, kBytes);

        constexpr int kLast = kMaxWavelength_nm - kMinWavelength_nm - 1;
        constexpr Int4 kFirstCell = {0, 0, 0, 0}, kLastCell = {kLast, kLast, kLast, kLast};
        const Float4 above = lambda_nm - kMin_nm;
        Int4 cell = __builtin_convertvector(above, Int4);
        cell = cell < kFirstCell ? kFirstCell : cell;
        cell = cell > kLastCell ? kLastCell : cell;
        const Float4 fraction = above - __builtin_convertvector(cell, Float4);
        const Float4 scaled = value / pdf;

        const auto term = [&](int i) {
            const Lines& lines = lines_[static_cast<std::size_t>(cell[i])];
            return scaled[i] * (lines.start + fraction[i] * lines.slope);
        };
        return (term(0) + term(1)) + (term(2) + term(3));
    }

    SensorOptions options_;
    std::optional<CameraFit> camera_fit_;
    std::vector<Cell> cells_;   // by nanometre
    std::vector<Lines> lines_;  // the same in single precision
};

}  // namespace emulsion
