#include "analysis/wavelength_noise.h"

#include <array>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "core/units.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/observer.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

namespace {

/// Draws that the mean is taken over.
constexpr int kDraws = 32;

/// xbar + ybar + zbar, which the bands count by.
double eye_at(std::size_t node) {
    const XYZd xyz = eval(cie_1931_2deg(), kMinWavelength_nm + static_cast<double>(node));
    return xyz.x + xyz.y + xyz.z;
}

/// The pixel's radiance at whole nanometres, in lm/W times what the film has: its sum with the observer is XYZ.
std::vector<double> radiance_of(const PilotChannels& channels, const ChannelValues& pixel,
                                std::span<const double> light) {
    std::vector<double> radiance(light.size());
    std::size_t begin = 0;
    for (std::size_t band = 0; band < channels.bands.count; ++band) {
        const auto end = static_cast<std::size_t>(channels.band_end_nm[band] - kMinWavelength_nm);
        double seen = 0.0;
        for (std::size_t n = begin; n < end; ++n) seen += light[n] * eye_at(n);
        for (std::size_t n = begin; n < end; ++n) {
            const double per_seen = seen > 0.0 ? light[n] / seen : 1.0 / (eye_at(n) * static_cast<double>(end - begin));
            radiance[n] = pixel[channels.bands.first + band] * per_seen;
        }
        begin = end;
    }
    return radiance;
}

XYZd seen_at(const std::vector<double>& radiance, double lambda_nm) {
    const double above = lambda_nm - kMinWavelength_nm;
    const auto cell = std::min(static_cast<std::size_t>(above), radiance.size() - 2);
    const double t = above - static_cast<double>(cell);
    return ((1.0 - t) * radiance[cell] + t * radiance[cell + 1]) * eval(cie_1931_2deg(), lambda_nm);
}

template <int N>
double mean_square(const std::vector<double>& radiance, const WavelengthSampler& sampler, double samples,
                   const ViewingConditions& viewing) {
    Pcg32 random(1);
    std::array<XYZd, kDraws> estimates;
    XYZd mean{};
    for (int draw = 0; draw < kDraws; ++draw) {
        // The first number is stratified over the draws: the hero strategies take no other.
        bool first = true;
        const auto next_u = [&] {
            const float u = random.next_float();
            if (!first) return u;
            first = false;
            return (static_cast<float>(draw) + u) / static_cast<float>(kDraws);
        };
        const SampledWavelengths<N> wavelengths = sample_wavelengths<N>(sampler, next_u);
        XYZd& estimate = estimates[static_cast<std::size_t>(draw)];
        for (std::size_t i = 0; i < N; ++i) {
            const double weight = 1.0 / (N * static_cast<double>(wavelengths.pdf[i]));
            estimate = estimate + weight * seen_at(radiance, static_cast<double>(wavelengths.lambda_nm[i]));
        }
        mean = mean + 1.0 / kDraws * estimate;
    }
    const Lab expected = lab_as_viewed(mean, viewing);
    double sum = 0.0;
    for (const XYZd& estimate : estimates) {
        const XYZd of_pixel = mean + 1.0 / std::sqrt(samples) * (estimate + -1.0 * mean);
        const double e = difference(Ciede2000Difference{}, expected, lab_as_viewed(of_pixel, viewing));
        sum += e * e;
    }
    return sum / kDraws;
}

}  // namespace

double wavelength_noise(const PilotChannels& channels, const ChannelValues& pixel, std::span<const double> light,
                        const WavelengthSampler& sampler, int wavelengths, double samples,
                        const ViewingConditions& viewing) {
    const std::vector<double> radiance = radiance_of(channels, pixel, light);
    double result = 0.0;
    for_each_wavelength_count([&]<int N>() {
        if (N == wavelengths) result = mean_square<N>(radiance, sampler, samples, viewing);
    });
    return result;
}

}  // namespace emulsion
