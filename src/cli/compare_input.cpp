#include "cli/compare_input.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <tuple>
#include <variant>

#include "cli/file_names.h"
#include "cli/messages.h"
#include "develop/picture_file.h"
#include "film/film.h"
#include "film/sensor_options.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/render.h"
#include "pathtracer/sample_sequence.h"
#include "pathtracer/scene_parser.h"

namespace emulsion::cli {

namespace {

ComparedPicture render_half(const PreparedScene& scene, const FilmOptions& film_options, const RenderOptions& options) {
    Film film(film_options);
    RenderProgress progress;
    render(scene, options, film, progress);
    ComparedPicture picture{.xyz = film.xyz_image(),
                            .window = bounds_of(film_options),
                            .width_px = film_options.width_px,
                            .height_px = film_options.height_px};
    picture.observer = film_options.sensor.observer;
    const auto unit = static_cast<float>(white_luminance_cdm2(film_options.sensor));
    for (XYZ& pixel : picture.xyz.pixels()) pixel = unit * pixel;
    return picture;
}

ComparedPicture render_scene(const SceneWithModel& input, CompareSide side, const SceneRenderSettings& settings) {
    RenderOptions options;
    options.threads = settings.threads;
    Scene scene = read_scene(input.scene);
    for (const std::string& warning : scene.warnings) print_warning(warning);
    if (settings.resolution_px) std::tie(scene.film.width_px, scene.film.height_px) = *settings.resolution_px;
    const FilmOptions film = film_options(scene);
    const int samples = settings.samples_per_pixel.value_or(samples_per_pixel(scene.sampler));
    if (samples < 2) throw std::invalid_argument("1 sample per pixel: expected 2 or more, to tell noise from bias");

    if (const auto* model = std::get_if<TransportModel>(&input.model)) options.model = *model;
    PreparedScene prepared(std::move(scene), options.threads, options.model);
    if (const auto* wish = std::get_if<AutoModel>(&input.model)) {
        const ModelAnalysis analysis = analyse_models(prepared, wish->budget, {.threads = options.threads});
        options.model = analysis.models[analysis.chosen].model;
        print_progress(reasons(analysis) + "\n");
    }
    const std::array<int, 2> shares = {samples - samples / 2, samples / 2};
    std::array<ComparedPicture, 2> halves;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        options.samples_per_pixel = shares[i];
        options.seed = (std::uint64_t{1} << 32u) + 4 * settings.seed + (side == CompareSide::b ? 2 : 0) + i;
        halves[i] = render_half(prepared, film, options);
    }
    return mean_of(halves[0], halves[1]);
}

}  // namespace

std::optional<SceneWithModel> parse_scene_with_model(const std::string& text) {
    const std::size_t at = text.rfind('@');
    if (at == std::string::npos) return std::nullopt;
    const std::filesystem::path scene = text.substr(0, at);
    const bool is_scene =
        has_extension(scene, ".pbrt") || (has_extension(scene, ".gz") && has_extension(scene.stem(), ".pbrt"));
    if (!is_scene) return std::nullopt;
    return SceneWithModel{scene, parse_model_choice(text.substr(at + 1))};
}

std::filesystem::path file_of(const std::string& text) {
    const std::optional<SceneWithModel> input = parse_scene_with_model(text);
    return input ? input->scene : std::filesystem::path(text);
}

ComparedPicture compare_input(const CompareInput& input, CompareSide side, const SceneRenderSettings& settings) {
    if (const std::optional<SceneWithModel> scene = parse_scene_with_model(input.text)) {
        return render_scene(*scene, side, settings);
    }
    const auto read = [&](const std::filesystem::path& path) {
        ComparedPicture picture = compared_picture(read_picture_and_layers(path, settings.threads));
        for (const std::string& note : picture.notes) print_warning(path.string() + ": " + note);
        return picture;
    };
    ComparedPicture picture = read(input.text);
    return input.again.empty() ? picture : mean_of(picture, read(input.again));
}

}  // namespace emulsion::cli
