#pragma once
// A grey card as paths of a few wavelengths see it.

#include <cstddef>

#include "core/random.h"
#include "film/sensor.h"
#include "spectrum/colorimetry.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion::stability {

/// Of reflectance 1/2 under a light, by N wavelengths a path.
template <int N>
class NoisyGrey {
  public:
    NoisyGrey(const WavelengthStrategy& strategy, const Spectrum& light)
        : light_(light),
          sampler_(prepare(strategy, wavelength_importance(light))),
          white_luminance_(xyz_of_radiance(light).y) {}

    /// XYZ of the light, Y = 1.
    [[nodiscard]] XYZd white() const { return 1.0 / white_luminance_ * xyz_of_radiance(light_); }

    /// The mean of so many paths, Y about 1/2.
    [[nodiscard]] XYZd pixel(int paths, Pcg32& random) const {
        XYZd sum;
        for (int path = 0; path < paths; ++path) {
            const SampledWavelengths<N> wavelengths =
                sample_wavelengths<N>(sampler_, [&random] { return random.next_float(); });
            SampledSpectrum<N> radiance;
            for (std::size_t k = 0; k < N; ++k) {
                radiance.value[k] =
                    static_cast<float>(0.5 * eval(light_, static_cast<double>(wavelengths.lambda_nm[k])));
            }
            sum = sum + 1.0 / (paths * white_luminance_) * sensor_.to_xyz_reference(wavelengths, radiance);
        }
        return sum;
    }

  private:
    Spectrum light_;
    WavelengthSampler sampler_;
    double white_luminance_;
    Sensor sensor_;
};

}  // namespace emulsion::stability
