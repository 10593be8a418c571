// What a sample costs on its way into the film, beside a plain double[4] add of the same numbers (the baseline of the
// ratios: divide the times of one run). Each benchmark first verifies that its sums are those of the plain adds.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/random.h"
#include "film/film.h"
#include "film/filter_sampler.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {
namespace {

constexpr int kTile_px = 16;
constexpr int kSamplesPerPixel = 64;
constexpr std::size_t kSamples = std::size_t{kTile_px} * kTile_px * kSamplesPerPixel;
constexpr PixelBounds kBounds{0, 0, kTile_px, kTile_px};

struct Samples {
    std::vector<XYZ> xyz;
    std::vector<float> weight;
    std::vector<SampledWavelengths<4>> wavelengths;
    std::vector<SampledSpectrum<4>> radiance;
};

/// The same as plain pointers, which no loop has to read again at each sample.
struct Inputs {
    std::span<const XYZ> xyz;
    std::span<const float> weight;
    std::span<const SampledWavelengths<4>> wavelengths;
    std::span<const SampledSpectrum<4>> radiance;
};

Inputs samples() {
    static const Samples made = [] {
        Samples all;
        Pcg32 random(1);
        const VisibleWavelengthPdf distribution;
        for (std::size_t i = 0; i < kSamples; ++i) {
            all.xyz.push_back({random.next_float(), random.next_float(), random.next_float()});
            all.weight.push_back(random.next_float() < 0.1f ? -1.1f : 1.1f);
            all.wavelengths.push_back(hero_wavelengths<4>(distribution, random.next_float()));
            SampledSpectrum<4> radiance;
            for (int k = 0; k < 4; ++k) radiance[k] = random.next_float();
            all.radiance.push_back(radiance);
        }
        return all;
    }();
    return {made.xyz, made.weight, made.wavelengths, made.radiance};
}

/// Calls add(x, y, i) for every sample, pixel by pixel, as a renderer does. The sums go through memory at each sample:
/// in a renderer, a whole path lies between two of them.
template <class Add>
void for_each_sample(Add add) {
    std::size_t i = 0;
    for (int y = 0; y < kTile_px; ++y) {
        for (int x = 0; x < kTile_px; ++x) {
            for (int s = 0; s < kSamplesPerPixel; ++s) {
                add(x, y, i++);
                benchmark::ClobberMemory();
            }
        }
    }
}

struct alignas(32) PlainPixel {
    std::array<double, 4> sum{};
};

void add_plain(std::vector<PlainPixel>& pixels, int x, int y, XYZ value, float weight) {
    auto& sum = pixels[static_cast<std::size_t>(y) * kTile_px + static_cast<std::size_t>(x)].sum;
    const auto w = static_cast<double>(weight);
    sum[0] += w * static_cast<double>(value.x);
    sum[1] += w * static_cast<double>(value.y);
    sum[2] += w * static_cast<double>(value.z);
    sum[3] += w;
}

enum class Input { xyz, spectral };

std::vector<PlainPixel> plain_sums(const Sensor& sensor, Input input) {
    std::vector<PlainPixel> pixels(std::size_t{kTile_px} * kTile_px);
    const Inputs all = samples();
    for_each_sample([&](int x, int y, std::size_t i) {
        const XYZ value = input == Input::xyz ? all.xyz[i] : sensor.to_xyz(all.wavelengths[i], all.radiance[i]);
        add_plain(pixels, x, y, value, all.weight[i]);
    });
    return pixels;
}

/// To 1e-5: enough for floats, and no mistake of a sample would pass.
template <class Sums>
bool same_sums(const BasicFilmTile<Sums>& tile, const std::vector<PlainPixel>& plain) {
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const WeightedSums sums = tile.pixels()[i].sums();
        const std::array<double, 4> got = {sums.xyz.x, sums.xyz.y, sums.xyz.z, sums.weight};
        for (std::size_t k = 0; k < 4; ++k) {
            if (std::abs(got[k] - plain[i].sum[k]) > 1e-5 * std::abs(plain[i].sum[k])) return false;
        }
    }
    return tile.dropped().count() == 0;
}

const FilmOptions kOptions{kTile_px, kTile_px, {}};

void plain_double4(benchmark::State& state) {
    const Inputs all = samples();
    std::vector<PlainPixel> pixels(std::size_t{kTile_px} * kTile_px);
    for (auto _ : state) {
        for_each_sample(
            [&pixels, all](int x, int y, std::size_t i) { add_plain(pixels, x, y, all.xyz[i], all.weight[i]); });
        benchmark::DoNotOptimize(pixels.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

template <class Sums>
void tile_xyz(benchmark::State& state) {
    const Inputs all = samples();
    const BasicFilm<Sums> film(kOptions);
    BasicFilmTile<Sums> tile = film.make_tile(kBounds);
    const auto pass = [&] {
        for_each_sample([&tile, all](int x, int y, std::size_t i) { tile.add(x, y, all.xyz[i], all.weight[i]); });
    };
    pass();
    if (!same_sums(tile, plain_sums(film.sensor(), Input::xyz)))
        return state.SkipWithError("sums differ from the plain ones");
    for (auto _ : state) {
        pass();
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

void tile_spectral4(benchmark::State& state) {
    const Inputs all = samples();
    const Film film(kOptions);
    FilmTile tile = film.make_tile(kBounds);
    const auto pass = [&] {
        for_each_sample([&tile, all](int x, int y, std::size_t i) {
            tile.add(x, y, all.wavelengths[i], all.radiance[i], all.weight[i]);
        });
    };
    pass();
    if (!same_sums(tile, plain_sums(film.sensor(), Input::spectral)))
        return state.SkipWithError("sums differ from the plain ones");
    for (auto _ : state) {
        pass();
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

/// A tile's pass of XYZ samples and its merge: the whole way into the film.
template <class Sums>
void tile_xyz_and_merge(benchmark::State& state) {
    const Inputs all = samples();
    BasicFilm<Sums> film(kOptions);
    BasicFilmTile<Sums> tile = film.make_tile(kBounds);
    const auto pass = [&] {
        tile.clear();
        for_each_sample([&tile, all](int x, int y, std::size_t i) { tile.add(x, y, all.xyz[i], all.weight[i]); });
        film.merge(tile);
    };
    pass();
    if (!same_sums(tile, plain_sums(film.sensor(), Input::xyz)) || film.sample_count() != kSamples) {
        return state.SkipWithError("sums differ from the plain ones");
    }
    for (auto _ : state) {
        pass();
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

/// The merge alone; an item is a pixel. Says how many bytes a pixel of the film has.
template <class Sums>
void merge(benchmark::State& state) {
    const Inputs all = samples();
    BasicFilm<Sums> film(kOptions);
    BasicFilmTile<Sums> tile = film.make_tile(kBounds);
    for_each_sample([&tile, all](int x, int y, std::size_t i) { tile.add(x, y, all.xyz[i], all.weight[i]); });
    film.merge(tile);
    const XYZ got = film.xyz_image()(3, 5);
    const WeightedSums sums = tile.pixels()[5 * kTile_px + 3].sums();
    if (got.y != static_cast<float>(sums.xyz.y / sums.weight)) return state.SkipWithError("merged sums differ");
    for (auto _ : state) {
        film.merge(tile);
        benchmark::ClobberMemory();
    }
    state.counters["film_bytes_per_pixel"] = sizeof(typename Sums::FilmPixel);
    state.counters["tile_bytes_per_pixel"] = sizeof(typename Sums::TilePixel);
    state.SetItemsProcessed(state.iterations() * kTile_px * kTile_px);
}

void filter_sample(benchmark::State& state, const Filter& filter) {
    const FilterSampler sampler(filter);
    Pcg32 random(1);
    std::vector<std::array<float, 2>> points(kSamples);
    for (auto& point : points) point = {random.next_float(), random.next_float()};
    double mean = 0.0;
    for (const auto& [u, v] : points) mean += static_cast<double>(sampler.sample(u, v).weight) / kSamples;
    if (std::abs(mean - 1.0) > 0.1) return state.SkipWithError("the weights' mean is not 1");
    for (auto _ : state) {
        float sum = 0.0f;
        for (const auto& [u, v] : points) {
            const FilterSample sample = sampler.sample(u, v);
            sum += sample.x_offset_px + sample.y_offset_px + sample.weight;
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

/// Prints mean, median and spread of nine runs.
void nine_times(benchmark::internal::Benchmark* benchmark) { benchmark->Repetitions(9)->ReportAggregatesOnly(); }

BENCHMARK(plain_double4)->Apply(nine_times)->Threads(1)->Threads(2);
BENCHMARK(tile_xyz<ExactSums>)->Apply(nine_times)->Threads(1)->Threads(2);
BENCHMARK(tile_xyz<DoubleSums>)->Apply(nine_times);
BENCHMARK(tile_xyz<FloatSums>)->Apply(nine_times);
BENCHMARK(tile_xyz<KahanFloatSums>)->Apply(nine_times);
BENCHMARK(tile_spectral4)->Apply(nine_times)->Threads(1)->Threads(2);
BENCHMARK(tile_xyz_and_merge<ExactSums>)->Apply(nine_times)->Threads(1)->Threads(2);
BENCHMARK(tile_xyz_and_merge<DoubleSums>)->Apply(nine_times);
BENCHMARK(tile_xyz_and_merge<FloatSums>)->Apply(nine_times);
BENCHMARK(tile_xyz_and_merge<KahanFloatSums>)->Apply(nine_times);
BENCHMARK(merge<ExactSums>)->Apply(nine_times);
BENCHMARK(merge<DoubleSums>)->Apply(nine_times);
BENCHMARK(merge<FloatSums>)->Apply(nine_times);
BENCHMARK(merge<KahanFloatSums>)->Apply(nine_times);
BENCHMARK_CAPTURE(filter_sample, box, Filter(BoxFilter{}))->Apply(nine_times);
BENCHMARK_CAPTURE(filter_sample, triangle, Filter(TriangleFilter{}))->Apply(nine_times);
BENCHMARK_CAPTURE(filter_sample, gaussian, Filter(GaussianFilter{}))->Apply(nine_times);
BENCHMARK_CAPTURE(filter_sample, mitchell, Filter(MitchellFilter{}))->Apply(nine_times);
BENCHMARK_CAPTURE(filter_sample, catmull_rom, Filter(CatmullRomFilter{}))->Apply(nine_times);
BENCHMARK_CAPTURE(filter_sample, sinc, Filter(LanczosSincFilter{}))->Apply(nine_times);
BENCHMARK_CAPTURE(filter_sample, blackman_harris, Filter(BlackmanHarrisFilter{}))->Apply(nine_times);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
