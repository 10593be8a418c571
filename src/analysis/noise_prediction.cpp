#include "analysis/noise_prediction.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/spectrum_nodes.h"

namespace emulsion {

namespace {

/// About how many of the pilot's pixels are looked at.
constexpr std::size_t kPixels = 256;

PixelLight light_of(const Pilot& pilot, std::size_t i) {
    const ChannelValues& pixel = pilot.pixels[i];
    PixelLight light{.xyz = xyz_of(pilot.channels, pilot.channels.bands, pixel)};
    if (!(light.xyz.y > 0.0)) return light;
    const double relative = pilot.luminance_error[i] / light.xyz.y;
    light.path_variance = relative * relative * pilot.samples_per_pixel;
    const double whole = pixel[pilot.channels.control];
    if (whole > 0.0) light.dispersed_share = std::clamp(1.0 - pixel[pilot.channels.marked] / whole, 0.0, 1.0);
    return light;
}

}  // namespace

NoisePrediction::NoisePrediction(const PreparedScene& scene, const Pilot& pilot, const ViewingConditions& viewing,
                                 const PilotOptions& options)
    : scene_(scene),
      viewing_(viewing),
      numbers_(std::holds_alternative<IndependentSampler>(scene.scene().sampler) ? PixelPaths::Numbers::independent
                                                                                 : PixelPaths::Numbers::even),
      threads_(options.threads),
      light_(sum_of_lights(scene.scene_spectra())) {
    const std::vector<double> light = node_integrals(light_);
    const std::size_t stride = 1 + pilot.pixels.size() / kPixels;
    for (std::size_t i = 0; i < pilot.pixels.size(); i += stride) {
        pixels_.push_back({light_of(pilot, i), ratio_to_light(pilot.channels, pilot.pixels[i], light)});
    }
}

double NoisePrediction::operator()(const TransportModel& model, double samples) const {
    const auto* spectral = std::get_if<SpectralModel>(&model);
    const PixelPaths paths{samples, numbers_};
    const WavelengthWeights weights(scene_.wavelengths(), light_);
    std::vector<double> squares(pixels_.size());
    parallel_for(0, static_cast<int>(pixels_.size()), threads_, [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        const Pixel& pixel = pixels_[i];
        const NoiseDraws draws{.seed = i};
        if (!(pixel.light.xyz.y > 0.0)) return;
        squares[i] = spectral == nullptr
                         ? channel_noise(pixel.light, paths, viewing_, draws)
                         : wavelength_noise(pixel.light, weights.by_number(pixel.ratio), weights.sampler(),
                                            spectral->wavelengths, paths, viewing_, draws);
    });
    return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0) / static_cast<double>(squares.size()));
}

}  // namespace emulsion
