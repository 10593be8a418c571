#include "analysis/model_analysis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/noise_prediction.h"
#include "core/nearest_rank.h"
#include "pathtracer/render.h"
#include "pathtracer/sample_sequence.h"
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

/// The pilot's own noise is in the differences that it shows, and adds to them in squares. The mean is of what it
/// shows. The largest hundredth would be that of the noisiest pixels: for it, noise is taken out again, as the halves
/// of the pilot's paths tell it.
ColourError error_of(const Pilot& pilot, const SeenPilot& exact, std::size_t part) {
    const PilotChannels::Part& model = pilot.channels.models[part];
    const auto difference_in = [&](const ChannelValues& pixel) {
        return xyz_of(pilot.channels, model, pixel) + -1.0 * xyz_of(pilot.channels, pilot.channels.bands, pixel);
    };
    std::vector<double> errors;
    double sum = 0.0;
    for (std::size_t i = 0; i < pilot.pixels.size(); ++i) {
        const XYZd xyz = xyz_of(pilot.channels, pilot.channels.bands, pilot.pixels[i]);
        const auto seen_beside = [&](const XYZd& off) {
            return difference(Ciede2000Difference{}, exact.exact[i], lab_as_viewed(xyz + off, exact.viewing));
        };
        const double shown = seen_beside(difference_in(pilot.pixels[i])),
                     noise = seen_beside(difference_in(pilot.noise[i]));
        errors.push_back(std::sqrt(std::max(0.0, shown * shown - noise * noise)));
        sum += shown;
    }
    return {sum / static_cast<double>(errors.size()), nearest_rank(errors, 99)};
}

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

std::string in_short(const ColourError& error) { return fmt::format("{:.2f} mean, {:.2f} p99", error.mean, error.p99); }
std::string in_short(const ErrorBudget& budget) { return fmt::format("{:g} mean, {:g} p99", budget.mean, budget.p99); }

/// Why models of channels were not looked at; empty: they were.
std::string why_only_spectral(const ModelAnalysis& analysis) {
    if (!analysis.only_spectral.empty()) return analysis.only_spectral;
    if (!analysis.disperses) return {};
    return fmt::format("glass disperses {:.2f} % of the light, which models of channels don't see",
                       100.0 * analysis.dispersed_share);
}

/// What the decision was made by.
std::string main_reason(const ModelAnalysis& analysis) {
    const ModelPrediction& chosen = analysis.models[analysis.chosen];
    if (!std::holds_alternative<SpectralModel>(chosen.model)) {
        return fmt::format("predicted dE00 {}; asked for {}", in_short(*chosen.error), in_short(analysis.budget));
    }
    const std::string why = why_only_spectral(analysis);
    return why.empty() ? "no cheaper model is predicted within dE00 " + in_short(analysis.budget) : why;
}

/// The best of what is cheaper and was not taken; of spectral models, the noise; what the next step up would cost.
std::string alternatives(const ModelAnalysis& analysis) {
    const ModelPrediction& chosen = analysis.models[analysis.chosen];
    std::vector<std::string> parts;
    const ModelPrediction* best = nullptr;
    for (std::size_t i = 0; i < std::min(analysis.chosen, channel_models().size()); ++i) {
        const ModelPrediction& cheaper = analysis.models[i];
        if (cheaper.error && (best == nullptr || cheaper.error->mean < best->error->mean)) best = &cheaper;
    }
    if (best != nullptr) parts.push_back(fmt::format("{} {}", to_text(best->model), in_short(*best->error)));
    const TransportModel usual = SpectralModel{};
    if (!std::holds_alternative<SpectralModel>(chosen.model)) {
        parts.push_back(
            fmt::format("{} would cost {:.2f}x", to_text(usual), relative_cost(usual) / relative_cost(chosen.model)));
        return fmt::format("{}", fmt::join(parts, "; "));
    }
    parts.push_back(fmt::format("noise dE00 {:.2f} in equal time", chosen.noise));
    const auto is_usual = [&](const ModelPrediction& p) { return p.model == usual; };
    const auto other = std::find_if(analysis.models.begin(), analysis.models.end(), is_usual);
    if (chosen.model != usual) parts.back() += fmt::format(", {} {:.2f}", to_text(usual), other->noise);
    return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

double relative_cost(const TransportModel& model) {
    if (const auto* basis = std::get_if<BasisModel>(&model)) {
        return basis->functions <= 3 ? 1.0 : basis->functions <= 4 ? 1.03 : 1.05;
    }
    const auto* spectral = std::get_if<SpectralModel>(&model);
    if (spectral == nullptr) return 1.0;
    switch (spectral->wavelengths) {
        case 1:
            return 0.91;
        case 2:
            return 1.04;
        case 4:
            return 1.10;
        case 8:
            return 1.18;
        case 16:
            return 1.34;
        default:
            return 1.77;
    }
}

ModelAnalysis analyse_models(PreparedScene& scene, const ErrorBudget& budget, const PilotOptions& options) {
    validate(budget);
    const Pilot pilot = trace_pilot(scene, channel_models(), options);
    const SeenPilot exact = seen(pilot);
    const NoisePrediction noise_of(scene, pilot, exact.viewing, options);
    const double samples = samples_per_pixel(scene.scene().sampler);

    ModelAnalysis analysis;
    analysis.budget = budget;
    analysis.only_spectral = why_not_of_channels(film_options(scene.scene()));
    note_dispersion(pilot, analysis);
    const auto add = [&](const TransportModel& model, const std::optional<ColourError>& error) {
        const double cost = relative_cost(model);
        const bool good = error && is_within(error->mean, error->p99, budget);
        analysis.models.push_back({model, error, cost, noise_of(model, samples / cost), good});
    };
    const bool only_spectral = analysis.disperses || !analysis.only_spectral.empty();
    for (std::size_t i = 0; i < channel_models().size(); ++i) {
        add(channel_models()[i], only_spectral ? std::nullopt : std::optional(error_of(pilot, exact, i)));
    }
    for (const TransportModel& model : spectral_models()) {
        scene.prepare_for(model);
        add(model, ColourError{});
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

std::string reasons(const ModelAnalysis& analysis, std::string_view separator) {
    return fmt::format("{}: {}{}{}", to_text(analysis.models[analysis.chosen].model), main_reason(analysis), separator,
                       alternatives(analysis));
}

}  // namespace emulsion
