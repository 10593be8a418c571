// What a million samples of four wavelengths cost through the C interface, and through the C++ batch behind it, beside
// the path tracer's own inner loop: tile.add, pixel by pixel (the baseline of the ratios: divide the times of one run).
// Each benchmark first verifies that its sums are those of the baseline.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "capi/emulsion.h"
#include "core/random.h"
#include "film/film.h"
#include "film/sample_batch.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {
namespace {

constexpr int kSize_px = 250, kSamplesPerPixel = 16;
constexpr std::size_t kSamples = std::size_t{kSize_px} * kSize_px * kSamplesPerPixel;
static_assert(kSamples == 1'000'000);
constexpr std::size_t kWavelengths = 4;

/// The same samples as a renderer's loop has them and as a batch has them.
struct Samples {
    std::vector<std::int32_t> x, y;
    std::vector<float> weight, lambda_nm, radiance, pdf;
    std::vector<SampledWavelengths<4>> wavelengths;
    std::vector<SampledSpectrum<4>> spectra;
};

const Samples& samples() {
    static const Samples made = [] {
        Samples all;
        Pcg32 random(1);
        const VisibleWavelengthPdf distribution;
        for (std::size_t i = 0; i < kSamples; ++i) {
            const auto pixel = static_cast<int>(i / kSamplesPerPixel);
            all.x.push_back(pixel % kSize_px);
            all.y.push_back(pixel / kSize_px);
            all.weight.push_back(random.next_float() < 0.1f ? -1.1f : 1.1f);
            all.wavelengths.push_back(hero_wavelengths<4>(distribution, random.next_float()));
            SampledSpectrum<4> radiance;
            for (int k = 0; k < 4; ++k) radiance[k] = random.next_float();
            all.spectra.push_back(radiance);
            const SampledWavelengths<4>& wavelengths = all.wavelengths.back();
            all.lambda_nm.insert(all.lambda_nm.end(), wavelengths.lambda_nm.begin(), wavelengths.lambda_nm.end());
            all.pdf.insert(all.pdf.end(), wavelengths.pdf.begin(), wavelengths.pdf.end());
            all.radiance.insert(all.radiance.end(), radiance.value.begin(), radiance.value.end());
        }
        return all;
    }();
    return made;
}

FilmOptions film_options() {
    FilmOptions options;
    options.width_px = options.height_px = kSize_px;
    return options;
}

void add_one_by_one(FilmTile& tile) {
    const Samples& all = samples();
    std::size_t i = 0;
    for (int y = 0; y < kSize_px; ++y) {
        for (int x = 0; x < kSize_px; ++x) {
            for (int s = 0; s < kSamplesPerPixel; ++s, ++i) {
                tile.add(x, y, all.wavelengths[i], all.spectra[i], all.weight[i]);
                benchmark::ClobberMemory();  // in a renderer, a whole path lies between two samples
            }
        }
    }
}

Image<XYZ> expected_picture() {
    Film film(film_options());
    FilmTile tile = film.make_tile(film.bounds());
    add_one_by_one(tile);
    film.merge(tile);
    return film.xyz_image();
}

void one_by_one(benchmark::State& state) {
    const Film film(film_options());
    FilmTile tile = film.make_tile(film.bounds());
    add_one_by_one(tile);
    for (auto _ : state) add_one_by_one(tile);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

void cpp_batch(benchmark::State& state) {
    const Samples& all = samples();
    Film film(film_options());
    FilmTile tile = film.make_tile(film.bounds());
    const auto add = [&] {
        add_batch(tile, BatchPixels{all.x, all.y, all.weight},
                  BatchRadiance{kWavelengths, all.lambda_nm, all.radiance, all.pdf});
    };
    add();
    film.merge(tile);
    if (film.xyz_image() != expected_picture()) return state.SkipWithError("sums differ from those one by one");
    for (auto _ : state) add();
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
}

/// In batches of so many samples: the benchmark's argument.
void c_batch(benchmark::State& state) {
    const Samples& all = samples();
    const auto batch = static_cast<std::size_t>(state.range(0));
    emulsion_film_options options;
    emulsion_film* film = nullptr;
    emulsion_tile* tile = nullptr;
    emulsion_film_options_init(&options, sizeof options);
    options.width_px = options.height_px = kSize_px;
    if (emulsion_film_create(&options, &film) != EMULSION_OK) return state.SkipWithError(emulsion_last_error());
    emulsion_tile_create(film, {0, 0, kSize_px, kSize_px}, &tile);
    const auto add = [&] {
        for (std::size_t i = 0; i < kSamples; i += batch) {
            emulsion_tile_add_spectral(tile, batch, &all.x[i], &all.y[i], &all.weight[i], kWavelengths,
                                       &all.lambda_nm[kWavelengths * i], &all.radiance[kWavelengths * i],
                                       &all.pdf[kWavelengths * i]);
        }
    };
    add();
    emulsion_film_merge_tile(film, tile);
    std::vector<float> xyz(std::size_t{3} * kSize_px * kSize_px);
    emulsion_film_read_xyz(film, xyz.data(), xyz.size());
    const Image<XYZ> expected = expected_picture();
    for (std::size_t i = 0; i < expected.pixels().size(); ++i) {
        if (expected.pixels()[i] == XYZ{xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}) continue;
        state.SkipWithError("sums differ from those one by one");
        break;
    }
    for (auto _ : state) add();
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSamples));
    emulsion_tile_destroy(tile);
    emulsion_film_destroy(film);
}

/// Prints mean, median and spread of nine runs.
void nine_times(benchmark::internal::Benchmark* benchmark) {
    benchmark->Repetitions(9)->ReportAggregatesOnly()->Unit(benchmark::kMillisecond);
}

BENCHMARK(one_by_one)->Apply(nine_times);
BENCHMARK(cpp_batch)->Apply(nine_times);
BENCHMARK(c_batch)->Apply(nine_times)->Arg(kSamples)->Arg(4000)->Arg(250);

}  // namespace
}  // namespace emulsion

BENCHMARK_MAIN();
