// Transport models on scenes: time and colour error, at equal samples and in equal time. And which of them `auto`
// takes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/model_analysis.h"
#include "chart/charts.h"
#include "chart/measure.h"
#include "compare/compare.h"
#include "film/film.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/render.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/scene_parser.h"
#include "pathtracer/transport_model.h"

namespace emulsion {

namespace {

/// How much is rendered.
struct Sizes {
    int width_px;           ///< of the picture; its height is in the scene's proportion
    int samples;            ///< at equal samples, per pixel
    int reference_samples;  ///< of each half of the reference
    int timed_samples;
    int timed_rounds;
    int rounds;  ///< seeds of the pictures whose errors are compared
};

Sizes sizes_of(const ChartOptions& options) {
    if (options.effort == ChartEffort::quick) return {32, 32, 512, 4, 2, 2};
    return {80, 128, 4096, 8, 15, 3};
}

std::vector<TransportModel> models(const ChartOptions& options) {
    std::vector<const char*> texts = {"rgb",
                                      "rgb:ACEScg",
                                      "rgb:sharp",
                                      "rgb-prefiltered",
                                      "basis:4",
                                      "basis:6",
                                      "basis:8",
                                      "spectral:1",
                                      "spectral:2",
                                      "spectral:4",
                                      "spectral:4:hero-illuminant",
                                      "spectral:8",
                                      "spectral:16"};
    if (options.effort == ChartEffort::quick) texts = {"rgb", "rgb-prefiltered", "basis:6", "spectral:4"};
    std::vector<TransportModel> all;
    all.reserve(texts.size());
    for (const char* text : texts) all.push_back(parse_transport_model(text));
    return all;
}

/// As short as it can be read.
std::string label_of(const TransportModel& model) {
    const std::string text = to_text(model);
    const std::size_t parameters = text.find(':', text.find("illuminant"));
    std::string label = text.substr(0, std::min(parameters, text.size()));
    const std::string usual = ":" + std::string(HeroVisible::kName);
    if (label.ends_with(usual)) label.resize(label.size() - usual.size());
    return label;
}

/// Without folder and ending, unless another scene has the same name.
std::string name_of(const std::filesystem::path& scene, const std::vector<std::filesystem::path>& scenes) {
    const auto same = std::count_if(scenes.begin(), scenes.end(),
                                    [&](const std::filesystem::path& other) { return other.stem() == scene.stem(); });
    return same > 1 ? scene.string() : scene.stem().string();
}

class ModelsOfScene {
  public:
    ModelsOfScene(const Scene& scene, std::string name, const ChartOptions& options)
        : name_(std::move(name)),
          threads_(options.threads),
          sizes_(sizes_of(options)),
          models_(models(options)),
          choice_(choose(scene)),
          scene_(resized(scene, sizes_), options.threads) {}

    /// Two panels: at equal samples, and in equal time.
    std::array<ChartPanel, 2> measure() {
        const std::vector<RelativeTime> times = measure_times();
        const ComparedPicture reference = picture(SpectralModel{8}, 2 * sizes_.reference_samples, kReferenceSeed);
        const ChartAxis error = {.label = "mean CIEDE2000", .least_drawn = 1e-3};
        std::array<ChartPanel, 2> panels = {
            ChartPanel{.title = fmt::format("{}: {} samples a pixel", name_, sizes_.samples),
                       .x = {.label = "time / time of rgb"},
                       .y = error},
            ChartPanel{.title = fmt::format("{}: in the time of rgb", name_),
                       .x = {.label = "samples a pixel that fit", .better = BetterEnd::neither},
                       .y = error}};
        for (std::size_t i = 0; i < models_.size(); ++i) {
            ChartPoint equal_samples = point_of(models_[i], sizes_.samples, reference);
            equal_samples.x = times[i].ratio;
            panels[0].points.push_back(std::move(equal_samples));
            const double fit = sizes_.samples / times[i].ratio.median;
            const int samples = std::max(2, static_cast<int>(std::lround(fit)));
            ChartPoint equal_time = point_of(models_[i], samples, reference);
            equal_time.x = exactly(samples);
            panels[1].points.push_back(std::move(equal_time));
        }
        const FilmSettings& film = scene_.scene().film;
        const double rgb_s_per_sample =
            times[0].seconds / sizes_.timed_samples / (static_cast<double>(film.width_px) * film.height_px);
        for (ChartPanel& panel : panels) {
            mark_front(panel);
            ChartPoint chosen = panel.points[choice_.model];
            chosen.series = "auto";
            chosen.label = "auto: " + chosen.label;
            chosen.details.emplace_back("seconds of analysis", choice_.seconds);
            chosen.details.emplace_back("analysis / rendering the file by rgb",
                                        choice_.seconds / (choice_.samples * rgb_s_per_sample));
            panel.points.push_back(std::move(chosen));
        }
        return panels;
    }

  private:
    static constexpr std::uint64_t kReferenceSeed = 1000;

    /// What `--model auto` renders a file by.
    struct AutoChoice {
        std::size_t model = 0;  ///< of models_
        double seconds = 0.0;   ///< that the analysis takes, on one thread
        double samples = 0.0;   ///< of all pixels, as the file asks for them
    };

    /// By the default budget, of the picture in its own size. Its model is measured even if it is none of the chart's.
    AutoChoice choose(const Scene& scene) {
        PreparedScene prepared(scene, threads_);
        std::vector<double> seconds;
        seconds.reserve(static_cast<std::size_t>(sizes_.rounds));
        TransportModel chosen;
        for (int round = 0; round < sizes_.rounds; ++round) {
            seconds.push_back(thread_seconds([&] {
                const ModelAnalysis analysis = analyse_models(prepared, {}, {.threads = 1});
                chosen = analysis.models[analysis.chosen].model;
            }));
        }
        const auto found = std::find(models_.begin(), models_.end(), chosen);
        const PixelBounds window = bounds_of(emulsion::film_options(scene));
        const double pixels = static_cast<double>(window.x1 - window.x0) * (window.y1 - window.y0);
        const AutoChoice choice{static_cast<std::size_t>(found - models_.begin()), spread_of(seconds).median,
                                pixels * samples_per_pixel(scene.sampler)};
        if (found == models_.end()) models_.push_back(chosen);
        return choice;
    }

    static Scene resized(Scene scene, const Sizes& sizes) {
        FilmSettings& film = scene.film;
        film.height_px = std::max(
            1, static_cast<int>(std::lround(static_cast<double>(film.height_px) * sizes.width_px / film.width_px)));
        film.width_px = sizes.width_px;
        film.pixel_bounds.reset();
        return scene;
    }

    [[nodiscard]] ComparedPicture half(const TransportModel& model, int samples, std::uint64_t seed,
                                       int threads) const {
        const FilmOptions film_options = emulsion::film_options(scene_.scene());
        Film film(film_options);
        RenderProgress progress;
        render(scene_, {.samples_per_pixel = samples, .seed = seed, .model = model, .threads = threads}, film,
               progress);
        ComparedPicture result{.xyz = film.xyz_image(),
                               .window = bounds_of(film_options),
                               .width_px = film_options.width_px,
                               .height_px = film_options.height_px};
        const auto unit = static_cast<float>(white_luminance_cdm2(film_options.sensor));
        for (XYZ& pixel : result.xyz.pixels()) pixel = unit * pixel;
        return result;
    }

    /// The mean of two independent halves, which tell its noise.
    ComparedPicture picture(const TransportModel& model, int samples, std::uint64_t seed) {
        scene_.prepare_for(model);
        return mean_of(half(model, samples - samples / 2, 2 * seed, threads_),
                       half(model, samples / 2, 2 * seed + 1, threads_));
    }

    ChartPoint point_of(const TransportModel& model, int samples, const ComparedPicture& reference) {
        std::vector<double> means, p99, bias, bias_error;
        for (int round = 0; round < sizes_.rounds; ++round) {
            const Comparison comparison =
                compare(reference, picture(model, samples, static_cast<std::uint64_t>(round)), {.threads = threads_});
            means.push_back(comparison.ciede2000.mean);
            p99.push_back(comparison.ciede2000.p99);
            if (const auto& parts = comparison.squared.parts) {
                bias.push_back(parts->bias_share());
                bias_error.push_back(parts->bias_share_standard_error());
            }
        }
        ChartPoint point{.series = std::string(std::visit([](const auto& chosen) { return chosen.kName; }, model)),
                         .label = label_of(model),
                         .y = spread_of(means),
                         .details = {{"samples", samples}, {"p99", spread_of(p99).median}}};
        if (!bias.empty()) {
            point.details.emplace_back("share of bias", spread_of(bias).median);
            point.details.emplace_back("its standard error", spread_of(bias_error).median);
        }
        return point;
    }

    /// Of rendering alone: scenes are prepared beforehand.
    std::vector<RelativeTime> measure_times() {
        const auto seconds = [&](const TransportModel& model, int round) {
            scene_.prepare_for(model);
            return thread_seconds(
                [&] { keep(half(model, sizes_.timed_samples, static_cast<std::uint64_t>(round), 1)); });
        };
        std::vector<std::vector<double>> ratios(models_.size()), all_seconds(models_.size());
        for (int round = 0; round < sizes_.timed_rounds; ++round) {
            for (std::size_t i = 0; i < models_.size(); ++i) {
                const double baseline_s = seconds(RgbModel{}, round), own_s = seconds(models_[i], round);
                ratios[i].push_back(own_s / baseline_s);
                all_seconds[i].push_back(own_s);
            }
        }
        std::vector<RelativeTime> times;
        for (std::size_t i = 0; i < models_.size(); ++i) {
            times.push_back({spread_of(ratios[i]), spread_of(all_seconds[i]).median});
        }
        return times;
    }

    std::string name_;
    int threads_;
    Sizes sizes_;
    std::vector<TransportModel> models_;  ///< rgb first
    AutoChoice choice_;
    PreparedScene scene_;
};

}  // namespace

Chart measure_models_chart(const ChartOptions& options) {
    const Sizes sizes = sizes_of(options);
    Chart chart{.name = "models",
                .title = "Transport models: what they cost, and what they lose",
                .note = fmt::format("Pictures {} pixels wide. Time of rendering on one thread. Error: mean CIEDE2000 "
                                    "against {} samples a pixel of spectral:8 (median and quartiles over {} seeds), "
                                    "white at 1/0.18 of the reference's log-average luminance. It is noise and bias "
                                    "together: more samples take away the first alone. A ring is around the model that "
                                    "auto takes.",
                                    sizes.width_px, 2 * sizes.reference_samples, sizes.rounds)};
    for (const std::filesystem::path& scene : options.scenes) {
        ModelsOfScene models_of_scene(read_scene(scene), name_of(scene, options.scenes), options);
        for (ChartPanel& panel : models_of_scene.measure()) chart.panels.push_back(std::move(panel));
    }
    return chart;
}

}  // namespace emulsion
