#include "measured_pixels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/model_analysis.h"
#include "core/nearest_rank.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/units.h"
#include "film/filter_sampler.h"
#include "pathtracer/camera.h"
#include "pathtracer/path_integrator.h"
#include "pathtracer/sample_sequence.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/observer.h"

namespace emulsion::test {

namespace {

/// Paths traced together.
constexpr std::size_t kBatch = 256;

template <class Transport>
XYZd colour_of(const PreparedScene& scene, const Path<Transport>& path) {
    XYZd xyz{};
    for (int k = 0; k < Transport::kChannels; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const auto radiance = static_cast<double>(path.radiance[k]);
        if constexpr (Transport::kSpectral) {
            const double scale =
                kLuminousEfficacy / (Transport::kChannels * static_cast<double>(path.wavelengths.pdf[i]));
            xyz = xyz + scale * radiance * eval(cie_1931_2deg(), static_cast<double>(path.wavelengths.lambda_nm[i]));
        } else if (i < scene.channels()->size()) {
            const auto& [x, y, z] = (*scene.channels())[i].xyz;
            xyz = xyz + radiance * XYZd{x, y, z};
        }
    }
    return xyz;
}

template <class Transport>
std::vector<XYZd> pixels_by(const PreparedScene& scene, const PixelPlaces& places, int samples, std::uint64_t seed) {
    const FilmSettings& film = scene.scene().film;
    const Sampler sampler = with_samples_per_pixel(scene.scene().sampler, samples);
    const FilterSampler filter(scene.scene().filter);
    const CameraRays camera(scene.scene().camera, film.width_px, film.height_px);
    std::vector<XYZd> pixels(places.size());
    parallel_for(0, static_cast<int>(places.size()), 0, [&](int index) {
        const auto [x, y] = places[static_cast<std::size_t>(index)];
        PathIntegrator<Transport> integrator(scene, scene.scene().integrator.max_depth);
        std::vector<Path<Transport>> paths;
        std::vector<double> weights;
        XYZd sum{};
        double weight_sum = 0.0;
        for (int i = 0; i < samples; ++i) {
            Path<Transport>& path = paths.emplace_back();
            path.samples = SampleSequence(sampler, seed, x, y, i);
            const float u_wavelength = path.samples.next_1d();
            if constexpr (Transport::kSpectral) {
                path.wavelengths =
                    sample_wavelengths<Transport::kChannels>(scene.wavelengths(), [&] { return u_wavelength; });
                path.index = typename Transport::Index(path.wavelengths.lambda_nm);
            }
            const auto [u, v] = path.samples.next_2d();
            const FilterSample place = filter.sample(u, v);
            weights.push_back(static_cast<double>(place.weight));
            const float x_px = static_cast<float>(x) + 0.5f + place.x_offset_px;
            const float y_px = static_cast<float>(y) + 0.5f + place.y_offset_px;
            path.ray = camera.has_lens() ? camera.ray(x_px, y_px, path.samples.next_2d()) : camera.ray(x_px, y_px);
            if (paths.size() < kBatch && i + 1 < samples) continue;
            integrator.trace(paths);
            for (std::size_t k = 0; k < paths.size(); ++k) sum = sum + weights[k] * colour_of(scene, paths[k]);
            weight_sum = std::accumulate(weights.begin(), weights.end(), weight_sum);
            paths.clear();
            weights.clear();
        }
        pixels[static_cast<std::size_t>(index)] = imaging_ratio(film.sensor) / weight_sum * sum;
    });
    return pixels;
}

ColourError error_between(const std::vector<XYZd>& a, const std::vector<XYZd>& b, const ViewingConditions& viewing) {
    std::vector<double> errors;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        errors.push_back(difference(Ciede2000Difference{}, lab_as_viewed(a[i], viewing), lab_as_viewed(b[i], viewing)));
        sum += errors.back();
    }
    return {sum / static_cast<double>(errors.size()), nearest_rank(errors, 99)};
}

}  // namespace

PixelPlaces spread_pixels(const Scene& scene, int count, std::uint64_t seed) {
    const int width = scene.film.width_px, height = scene.film.height_px;
    const double side = std::sqrt(count / (static_cast<double>(width) * height));
    const int columns = std::max(1, static_cast<int>(std::lround(side * width)));
    const int rows = std::max(1, static_cast<int>(std::lround(side * height)));
    Pcg32 random(seed);
    const auto within = [&random](int cell, int cells, int size) {
        const int begin = cell * size / cells, end = (cell + 1) * size / cells;
        return begin + static_cast<int>(random.next_float() * static_cast<float>(end - begin));
    };
    PixelPlaces places;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const int x_px = within(x, columns, width);
            places.emplace_back(x_px, within(y, rows, height));
        }
    }
    return places;
}

std::vector<XYZd> measured_pixels(PreparedScene& scene, const TransportModel& model, const PixelPlaces& places,
                                  int samples, std::uint64_t seed) {
    scene.prepare_for(model);
    std::vector<XYZd> pixels;
    if (const auto* spectral = std::get_if<SpectralModel>(&model)) {
        for_each_wavelength_count([&]<int N>() {
            if (N == spectral->wavelengths) pixels = pixels_by<SpectralTransport<N>>(scene, places, samples, seed);
        });
        return pixels;
    }
    switch (compiled_channels(static_cast<int>(scene.channels()->size()))) {
        case 3:
            return pixels_by<FixedTransport<3>>(scene, places, samples, seed);
        case 4:
            return pixels_by<FixedTransport<4>>(scene, places, samples, seed);
        default:
            return pixels_by<FixedTransport<8>>(scene, places, samples, seed);
    }
}

double measured_noise(PreparedScene& scene, const TransportModel& model, const PixelPlaces& places, int samples) {
    const std::vector<XYZd> first = measured_pixels(scene, model, places, samples, 21),
                            second = measured_pixels(scene, model, places, samples, 22);
    const ViewingConditions viewing = viewing_of(first);
    double sum = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double e =
            difference(Ciede2000Difference{}, lab_as_viewed(first[i], viewing), lab_as_viewed(second[i], viewing));
        sum += e * e;
    }
    return std::sqrt(0.5 * sum / static_cast<double>(places.size()));
}

ViewingConditions viewing_of(const std::vector<XYZd>& pixels) {
    double log_sum = 0.0, count = 0.0;
    for (const XYZd& p : pixels) {
        if (!(p.y > 0.0)) continue;
        log_sum += std::log(p.y);
        count += 1.0;
    }
    return {default_white(cie_1931_2deg()), white_luminance_of_log_average(std::exp(log_sum / count))};
}

MeasuredError measured_error(PreparedScene& scene, const TransportModel& model, const TransportModel& reference,
                             const PixelPlaces& places, int samples) {
    const std::vector<XYZd> reference_1 = measured_pixels(scene, reference, places, samples, 11),
                            reference_2 = measured_pixels(scene, reference, places, samples, 12);
    const std::vector<XYZd> model_1 = measured_pixels(scene, model, places, samples, 11),
                            model_2 = measured_pixels(scene, model, places, samples, 12);
    std::vector<XYZd> exact, approximate, noisy;
    for (std::size_t i = 0; i < places.size(); ++i) {
        exact.push_back(0.5 * (reference_1[i] + reference_2[i]));
        approximate.push_back(0.5 * (model_1[i] + model_2[i]));
        const XYZd first = model_1[i] + -1.0 * reference_1[i], second = model_2[i] + -1.0 * reference_2[i];
        noisy.push_back(exact[i] + 0.5 * (first + -1.0 * second));
    }
    const ViewingConditions viewing = viewing_of(exact);
    const ColourError error = error_between(exact, approximate, viewing), noise = error_between(exact, noisy, viewing);
    return {error.mean, error.p99, noise.mean, noise.p99};
}

}  // namespace emulsion::test
