#include "pathtracer/light_powers.h"

#include <numbers>
#include <numeric>

#include "spectrum/colorimetry.h"

namespace emulsion {

double photometric_strength(const ScaledSpectrum& spectrum) {
    return photometric_integral(spectrum.spectrum) * spectrum.scale;
}

double spot_solid_angle(double cos_full, double cos_none) noexcept {
    // 3 t^2 - 2 t^3 is 1/2 in the mean.
    return 2.0 * std::numbers::pi * ((1.0 - cos_full) + 0.5 * (cos_full - cos_none));
}

std::vector<double> LightPowers::weights() const {
    const double total = std::accumulate(emitter.begin(), emitter.end(), 0.0);
    std::vector<double> weights(emitter.size());
    std::size_t begin = 0;
    for (const std::size_t end : light_end) {
        const auto first = emitter.begin() + static_cast<std::ptrdiff_t>(begin);
        const double of_light = std::accumulate(first, emitter.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
        const double equal_share = 1.0 / static_cast<double>(light_end.size());
        for (std::size_t i = begin; i < end; ++i) {
            const double within_light = of_light > 0.0 ? emitter[i] / of_light : 1.0 / static_cast<double>(end - begin);
            weights[i] = within_light * 0.5 * (equal_share + (total > 0.0 ? of_light / total : equal_share));
        }
        begin = end;
    }
    return weights;
}

}  // namespace emulsion
