// What a scene's transport model makes of its spectra.

#include <algorithm>

#include "pathtracer/prepared_scene.h"
#include "spectrum/colorimetry.h"
#include "spectrum/sigmoid_table.h"
#include "spectrum/wavelength_importance.h"

namespace emulsion {

namespace {

/// The most reflectances that a model is fitted to.
constexpr std::size_t kMostReflectances = 256;

/// Pictures count by the means of kPatches^2 patches.
constexpr int kPatches = 4;

void add_once(std::vector<Spectrum>& spectra, Spectrum spectrum) {
    if (spectra.size() == kMostReflectances) return;
    if (std::find(spectra.begin(), spectra.end(), spectrum) == spectra.end()) spectra.push_back(std::move(spectrum));
}

RGB mean_of(const Image<RGB>& picture, int column, int row) {
    const auto bounds = [](int i, int size) {
        const int begin = i * size / kPatches;
        return std::pair(begin, std::max((i + 1) * size / kPatches, begin + 1));
    };
    const auto [x0, x1] = bounds(column, picture.width());
    const auto [y0, y1] = bounds(row, picture.height());
    RGBd sum{};
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const RGB& texel = picture(x, y);
            sum = sum + RGBd{texel.r, texel.g, texel.b};
        }
    }
    const RGBd mean = 1.0 / (static_cast<double>(x1 - x0) * (y1 - y0)) * sum;
    return {static_cast<float>(mean.r), static_cast<float>(mean.g), static_cast<float>(mean.b)};
}

void add_colours_of(const Image<RGB>& picture, ColorSpace space, std::vector<Spectrum>& spectra) {
    const SigmoidTable sigmoids(rgb_space_of(space));
    for (int row = 0; row < kPatches; ++row) {
        for (int column = 0; column < kPatches; ++column) {
            add_once(spectra, sigmoid_of(sigmoids.unbounded(mean_of(picture, column, row)).sigmoid));
        }
    }
}

/// Which the scene has to be known for.
bool knows_scene(const TransportModel& model) noexcept {
    const auto* spectral = std::get_if<SpectralModel>(&model);
    return spectral == nullptr || !std::holds_alternative<HeroVisible>(spectral->strategy);
}

}  // namespace

void PreparedScene::prepare_for(const TransportModel& model) {
    validate(model);
    model_ = model;
    channels_.reset();
    wavelengths_ = WavelengthSampler{};
    if (!knows_scene(model)) return;
    if (const auto* spectral = std::get_if<SpectralModel>(&model)) {
        wavelengths_ = prepare(spectral->strategy, importance());
        return;
    }
    prepare_for(*channels_of(model, scene_spectra()));
    model_ = model;
}

void PreparedScene::prepare_for(FixedChannels channels) {
    model_.reset();
    channels_ = std::move(channels);
    spectra_.prepare(*channels_);
    materials_->prepare(*channels_);
    for (const Emitter& emitter : emitters_) {
        const auto* image = std::get_if<ImageEmitter>(&emitter.geometry);
        if (image == nullptr) continue;
        const Spectrum& illuminant = spectra_.sources()[emitter.spectrum].spectrum.spectrum;
        for (const auto& map : environment_maps_) {
            if (map.get() == image->map) map->prepare(*channels_, illuminant);
        }
    }
}

bool PreparedScene::is_prepared_for(const TransportModel& model) const noexcept {
    return !knows_scene(model) || model == model_;
}

SceneSpectra PreparedScene::scene_spectra() const {
    SceneSpectra scene;
    for (std::size_t i = 0; i < emitters_.size(); ++i) {
        if (!(flux_[i] > 0.0)) continue;
        const Spectrum& spectrum = spectra_.sources()[emitters_[i].spectrum].spectrum.spectrum;
        const auto known = std::find_if(scene.lights.begin(), scene.lights.end(),
                                        [&](const auto& light) { return light.spectrum == spectrum; });
        if (known != scene.lights.end()) {
            known->flux += flux_[i];
        } else {
            scene.lights.push_back({spectrum, flux_[i]});
        }
    }
    const std::span<const SpectrumTables::Source> sources = spectra_.sources();
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Spectrum& spectrum = sources[i].spectrum.spectrum;
        if (sources[i].role == SpectrumTables::Role::reflectance) add_once(scene.reflectances, spectrum);
        if (sources[i].role == SpectrumTables::Role::metal) {
            add_once(scene.reflectances, normal_reflectance(spectrum, sources[i + 1].spectrum.spectrum));
            ++i;
        }
    }
    for (const ReflectanceTexture& texture : scene_.reflectance_textures) {
        const auto* image = std::get_if<ImageTexture<RGB>>(&texture);
        if (image != nullptr) add_colours_of(image->image->texels, image->image->space, scene.reflectances);
    }
    for (const Light& light : scene_.lights) {
        const auto* image = std::get_if<ImageInfiniteLight>(&light);
        if (image != nullptr) add_colours_of(*image->texels, image->space, scene.reflectances);
    }
    return scene;
}

/// Tables give a line without width the nanometre that it lies in: so does its share of the samples.
WavelengthImportance PreparedScene::importance() const {
    WavelengthImportance sum;
    const SceneSpectra scene = scene_spectra();
    if (scene.lights.empty()) sum.per_nm.fill(1.0);
    for (const auto& light : scene.lights) {
        const WavelengthImportance one = wavelength_importance(light.spectrum);
        const double scale = light.flux / photometric_integral(light.spectrum);
        for (std::size_t i = 0; i < sum.per_nm.size(); ++i) sum.per_nm[i] += scale * one.per_nm[i];
        for (const LineImportance& line : one.lines) {
            const auto cell = static_cast<std::size_t>(line.lambda_nm - kMinWavelength_nm);
            sum.per_nm[std::min(cell, sum.per_nm.size() - 1)] += scale * line.importance;
        }
    }
    return sum;
}

}  // namespace emulsion
