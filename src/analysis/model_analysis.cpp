#include "analysis/model_analysis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/wavelength_noise.h"
#include "core/nearest_rank.h"
#include "pathtracer/render.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/spectrum_nodes.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/observer.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion {

namespace {

/// What is chosen from, by cost.
const std::array<TransportModel, 4>& channel_models() {
    static const std::array<TransportModel, 4> models = {RgbModel{}, PrefilteredRgbModel{}, BasisModel{4},
                                                         BasisModel{8}};
    return models;
}
std::vector<TransportModel> spectral_models() {
    std::vector<TransportModel> models;
    for (const int wavelengths : {1, 2, 4, 8, 16, 32}) {
        models.emplace_back(SpectralModel{wavelengths, HeroVisible{}});
        models.emplace_back(SpectralModel{wavelengths, HeroIlluminant{}});
    }
    return models;
}

/// The pilot's pixels as colours, and how they are looked at.
struct SeenPilot {
    std::vector<Lab> exact;
    ViewingConditions viewing;
};

SeenPilot seen(const Pilot& pilot) {
    std::vector<XYZd> xyz;
    double log_sum = 0.0, positive = 0.0;
    for (const ChannelValues& pixel : pilot.pixels) {
        xyz.push_back(xyz_of(pilot.channels, pilot.channels.bands, pixel));
        if (!(xyz.back().y > 0.0)) continue;
        log_sum += std::log(xyz.back().y);
        positive += 1.0;
    }
    SeenPilot result;
    const double log_average = positive > 0.0 ? std::exp(log_sum / positive) : 1.0;
    result.viewing = {default_white(cie_1931_2deg()), white_luminance_of_log_average(log_average)};
    for (const XYZd& v : xyz) result.exact.push_back(lab_as_viewed(v, result.viewing));
    return result;
}

void predict_error(const Pilot& pilot, const SeenPilot& exact, std::size_t part, ModelPrediction& prediction) {
    std::vector<double> errors;
    double sum = 0.0;
    for (std::size_t i = 0; i < pilot.pixels.size(); ++i) {
        const XYZd xyz = xyz_of(pilot.channels, pilot.channels.models[part], pilot.pixels[i]);
        errors.push_back(difference(Ciede2000Difference{}, exact.exact[i], lab_as_viewed(xyz, exact.viewing)));
        sum += errors.back();
    }
    prediction.mean = sum / static_cast<double>(errors.size());
    prediction.p99 = nearest_rank(errors, 99);
}

/// How noisy pixels are at the time that rgb takes for the scene's samples; of some pixels, evenly spread.
class PixelNoise {
  public:
    PixelNoise(const PreparedScene& scene, const Pilot& pilot, const SeenPilot& exact, int samples_per_pixel_of_pilot)
        : scene_(scene),
          pilot_(pilot),
          exact_(exact),
          samples_(samples_per_pixel(scene.scene().sampler)),
          samples_of_pilot_(
              samples_per_pixel(with_samples_per_pixel(scene.scene().sampler, samples_per_pixel_of_pilot))),
          light_(node_integrals(sum_of_lights(scene.scene_spectra()))) {}

    /// Root mean square CIEDE2000 of a model that the scene is prepared for.
    [[nodiscard]] double operator()(const ModelPrediction& prediction) const {
        constexpr std::size_t kPixels = 256;
        const std::size_t stride = 1 + pilot_.pixels.size() / kPixels;
        const auto* spectral = std::get_if<SpectralModel>(&prediction.model);
        const double samples = samples_ / prediction.cost;
        double sum = 0.0, count = 0.0;
        for (std::size_t i = 0; i < pilot_.pixels.size(); i += stride) {
            sum += of_light(i, samples);
            if (spectral != nullptr) {
                sum += wavelength_noise(pilot_.channels, pilot_.pixels[i], light_, scene_.wavelengths(),
                                        spectral->wavelengths, samples, exact_.viewing);
            }
            count += 1.0;
        }
        return std::sqrt(sum / count);
    }

  private:
    /// Mean square difference that the paths' own variance makes in a pixel of this many samples.
    [[nodiscard]] double of_light(std::size_t pixel, double samples) const {
        const XYZd xyz = xyz_of(pilot_.channels, pilot_.channels.bands, pilot_.pixels[pixel]);
        if (!(xyz.y > 0.0)) return 0.0;
        const double relative = pilot_.luminance_error[pixel] / xyz.y * std::sqrt(samples_of_pilot_ / samples);
        const Lab brighter = lab_as_viewed((1.0 + relative) * xyz, exact_.viewing);
        const double e = difference(Ciede2000Difference{}, exact_.exact[pixel], brighter);
        return e * e;
    }

    const PreparedScene& scene_;
    const Pilot& pilot_;
    const SeenPilot& exact_;
    double samples_, samples_of_pilot_;
    std::vector<double> light_;  // of the scene, at whole nanometres
};

void note_dispersion(const Pilot& pilot, ModelAnalysis& analysis) {
    double control = 0.0, marked = 0.0;
    std::vector<double> shares;
    for (const ChannelValues& pixel : pilot.pixels) {
        const double whole = pixel[pilot.channels.control], kept = pixel[pilot.channels.marked];
        control += whole;
        marked += kept;
        shares.push_back(whole > 0.0 ? 1.0 - kept / whole : 0.0);
    }
    analysis.dispersed_share = control > 0.0 ? 1.0 - marked / control : 0.0;
    analysis.disperses = analysis.dispersed_share > kDispersionSeen || nearest_rank(shares, 99) > kDispersionSeen;
}

std::string in_short(const ModelPrediction& p) {
    return fmt::format("{} {:.2g} mean, {:.2g} p99", to_text(p.model), p.mean, p.p99);
}

}  // namespace

double relative_cost(const TransportModel& model) {
    if (const auto* basis = std::get_if<BasisModel>(&model)) {
        return basis->functions <= 3 ? 1.0 : basis->functions <= 4 ? 1.02 : 1.04;
    }
    const auto* spectral = std::get_if<SpectralModel>(&model);
    if (spectral == nullptr) return 1.0;
    switch (spectral->wavelengths) {
        case 1:
            return 0.92;
        case 2:
            return 1.02;
        case 4:
            return 1.08;
        case 8:
            return 1.18;
        case 16:
            return 1.36;
        default:
            return 1.78;
    }
}

ModelAnalysis analyse_models(PreparedScene& scene, const ErrorBudget& budget, const PilotOptions& options) {
    validate(budget);
    const Pilot pilot = trace_pilot(scene, channel_models(), options);
    const SeenPilot exact = seen(pilot);
    const PixelNoise noise_of(scene, pilot, exact, options.samples_per_pixel);

    ModelAnalysis analysis;
    analysis.budget = budget;
    analysis.only_spectral = why_not_of_channels(film_options(scene.scene()));
    note_dispersion(pilot, analysis);
    const auto add = [&](const TransportModel& model) -> ModelPrediction& {
        ModelPrediction& prediction = analysis.models.emplace_back();
        prediction.model = model;
        prediction.cost = relative_cost(model);
        return prediction;
    };
    for (std::size_t i = 0; i < channel_models().size(); ++i) {
        ModelPrediction& prediction = add(channel_models()[i]);
        predict_error(pilot, exact, i, prediction);
        prediction.noise = noise_of(prediction);
        prediction.good_enough =
            is_within(prediction.mean, prediction.p99, budget) && !analysis.disperses && analysis.only_spectral.empty();
    }
    for (const TransportModel& model : spectral_models()) {
        scene.prepare_for(model);
        ModelPrediction& prediction = add(model);
        prediction.noise = noise_of(prediction);
        prediction.good_enough = true;
    }

    const auto first_spectral = analysis.models.begin() + channel_models().size();
    const auto is_good = [](const ModelPrediction& p) { return p.good_enough; };
    const auto is_less_noisy = [](const ModelPrediction& a, const ModelPrediction& b) { return a.noise < b.noise; };
    auto chosen = std::find_if(analysis.models.begin(), first_spectral, is_good);
    if (chosen == first_spectral) chosen = std::min_element(first_spectral, analysis.models.end(), is_less_noisy);
    analysis.chosen = static_cast<std::size_t>(chosen - analysis.models.begin());
    scene.prepare_for(chosen->model);
    return analysis;
}

std::string reasons(const ModelAnalysis& analysis) {
    const ModelPrediction& chosen = analysis.models[analysis.chosen];
    const bool spectral = std::holds_alternative<SpectralModel>(chosen.model);
    std::string first = to_text(chosen.model) + ": ";
    if (!spectral) {
        first += fmt::format("predicted dE00 {:.2g} mean, {:.2g} p99; asked for {:g} and {:g}", chosen.mean, chosen.p99,
                             analysis.budget.mean, analysis.budget.p99);
    } else if (!analysis.only_spectral.empty()) {
        first += analysis.only_spectral;
    } else if (analysis.disperses) {
        first += fmt::format("glass disperses {:.2g} % of the light", 100.0 * analysis.dispersed_share);
    } else {
        first += fmt::format("no cheaper model is predicted within dE00 {:g} mean, {:g} p99", analysis.budget.mean,
                             analysis.budget.p99);
    }
    // The best of what is cheaper and was not taken; or what the next step up would cost.
    std::string second;
    const auto cheaper_end =
        analysis.models.begin() + static_cast<std::ptrdiff_t>(std::min(analysis.chosen, channel_models().size()));
    const auto best = std::min_element(analysis.models.begin(), cheaper_end,
                                       [](const auto& a, const auto& b) { return a.mean < b.mean; });
    if (best != cheaper_end) second = in_short(*best);
    if (!spectral) {
        const TransportModel usual = SpectralModel{};
        second += fmt::format("{}{} would cost {:.2f}x", second.empty() ? "" : "; ", to_text(usual),
                              relative_cost(usual) / chosen.cost);
    }
    return first + "\n" + second;
}

}  // namespace emulsion
