#pragma once
// The sensor: from the radiance at the wavelengths of one path to absolute XYZ.
// Radiance in W m^-2 sr^-1 nm^-1, wavelengths in nm, densities in 1/nm, Y in cd/m^2 times the imaging ratio.
//
// Whatever the options, a sensor is three functions of the wavelength: balance * M * curves * 683 * imaging ratio. All
// of that goes into one table, so that a camera, another observer or a white balance cost nothing at each sample.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/color.h"
#include "core/units.h"
#include "film/response_table.h"
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
    /// wavelengths were drawn with those densities. Wavelengths with a pdf of 0, as renderers leave behind where they
    /// have given up a wavelength, and those outside the range add 0. The result is not finite if a wavelength is not,
    /// or if a pdf is NaN, or if a radiance is not finite whose pdf is not 0.
    ///
    /// Single precision: agrees with to_xyz_reference() to 4e-6 of the sum of all terms taken positive; that is 4e-6 of
    /// X + Y + Z for an observer and radiances of one sign.
    template <int N>
    [[nodiscard]] SensorSample sense(const SampledWavelengths<N>& wavelengths,
                                     const SampledSpectrum<N>& radiance) const noexcept {
        static_assert(N <= 4 || N % 4 == 0, "wavelengths are read in fours");
        const auto sum_from = [&](std::size_t first) {
            const auto four =
                FourWavelengths::load(wavelengths.lambda_nm.data() + first, wavelengths.pdf.data() + first,
                                      radiance.value.data() + first, std::min(N, 4));
            return responses_.sum(four, 4.0f / static_cast<float>(N));
        };
        Float4 sum = sum_from(0);
        for (std::size_t first = 4; first < N; first += 4) sum += sum_from(first);
        return {{sum[0], sum[1], sum[2]}, sum[3]};
    }
    /// The same for any number N >= 1 of wavelengths, of which all three have to have as many: the same bits as for N
    /// known to the compiler.
    [[nodiscard]] SensorSample sense(std::span<const float> lambda_nm, std::span<const float> radiance,
                                     std::span<const float> pdf) const noexcept;
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
            const auto pdf = static_cast<double>(wavelengths.pdf[i]);
            const double scaled = pdf == 0.0 ? 0.0 : static_cast<double>(radiance.value[i]) / pdf;
            sum = sum + scaled * response(static_cast<double>(wavelengths.lambda_nm[i]));
        }
        return (1.0 / N) * sum;
    }

    /// 683 imaging_ratio times the responses, lm/W, in double precision; 0 outside [kMinWavelength_nm,
    /// kMaxWavelength_nm), NaN if lambda_nm is not finite. At a jump, the value above it: 0 at kMaxWavelength_nm.
    [[nodiscard]] XYZd response(double lambda_nm) const noexcept;
    /// 683 imaging_ratio ybar(lambda) of the observer, lm/W: what SensorSample::luminance is made with.
    [[nodiscard]] double luminance_response(double lambda_nm) const noexcept;

    [[nodiscard]] const SensorOptions& options() const noexcept { return options_; }
    [[nodiscard]] double imaging_ratio() const noexcept { return emulsion::imaging_ratio(options_); }
    /// How well the camera's curves could be brought to XYZ; unset without a camera.
    [[nodiscard]] const std::optional<CameraFit>& camera_fit() const noexcept { return camera_fit_; }

  private:
    struct Response {
        XYZd xyz;
        double luminance = 0.0;
    };
    // Neighbours don't share their values: there may be a jump between them.
    struct Cell {
        Response start, end;
    };

    [[nodiscard]] Response at(double lambda_nm) const noexcept;

    SensorOptions options_;
    std::optional<CameraFit> camera_fit_;
    std::vector<Cell> cells_;  // by nanometre
    ResponseTable responses_;  // the same in single precision
};

}  // namespace emulsion
