#pragma once
// Films of every kind, with samples of every kind, small enough to be damaged bit by bit.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/random.h"
#include "film/film.h"
#include "film/film_state.h"
#include "film/filter_sampler.h"
#include "sensor_fixture.h"

namespace emulsion::testing {

struct NamedFilm {
    std::string name;
    FilmOptions options;
};

/// Every option at work somewhere, and all of them together.
inline std::vector<NamedFilm> every_film() {
    const PixelBounds crop{2, 1, 7, 5};
    FilmOptions all{.width_px = 9,
                    .height_px = 6,
                    .sensor = {.exposure_time_s = 0.1,
                               .iso = 800.0,
                               .observer = "cie_1964_10deg",
                               .camera = CameraSensor{humps_camera(), {}},
                               .white_balance = WhiteBalance{TemperatureWhite{3200.0}}},
                    .crop = crop,
                    .filter = MitchellFilter{},
                    .filter_use = FilterUse::splatted,
                    .light_splats = true,
                    .variance = FilmVariance::xyz,
                    .spectrum = SpectralBuckets{.count = 3, .min_nm = 400.0, .max_nm = 700.1},
                    .aux = {known_aux_layer("albedo"), known_aux_layer("depth"), {"id_2", {"a-b"}}},
                    .firefly_control = LuminanceClamp{.max_luminance_cdm2 = 3.1f}};
    const FilmOptions plain{.width_px = 5, .height_px = 4};
    std::vector<NamedFilm> films = {{"plain", plain}, {"all", all}};
    const auto add = [&](const std::string& name, auto change) {
        films.push_back({name, plain});
        change(films.back().options);
    };
    add("crop", [&](FilmOptions& o) { o.crop = PixelBounds{1, 2, 4, 3}; });
    add("crop of everything", [&](FilmOptions& o) { o.crop = bounds_of(o); });
    add("variance", [](FilmOptions& o) { o.variance = FilmVariance::luminance; });
    add("variance under lobes", [](FilmOptions& o) {
        o.filter = CatmullRomFilter{};
        o.variance = FilmVariance::luminance;
    });
    add("splats", [](FilmOptions& o) { o.light_splats = true; });
    add("splatted", [](FilmOptions& o) {
        o.filter = GaussianFilter{};
        o.filter_use = FilterUse::splatted;
    });
    add("median", [](FilmOptions& o) { o.firefly_control = MedianOfMeans{.groups = 3}; });
    add("sensor", [](FilmOptions& o) { o.sensor = {.exposure_time_s = 1.0 / 3.0, .iso = 64.0}; });
    return films;
}

/// Samples [begin, end) of every place of the film: values of every size, bad ones of every kind among them; what a
/// sample is depends on its place and its number only.
inline void add_samples(Film& film, std::uint64_t begin, std::uint64_t end) {
    const FilmOptions& options = film.options();
    const PixelBounds places = film.sample_bounds();
    const FilterSampler sampler(options.filter);
    FilmTile tile = film.make_tile(places);
    for (std::uint64_t index = begin; index < end; ++index) {
        for (int y = places.y0; y < places.y1; ++y) {
            for (int x = places.x0; x < places.x1; ++x) {
                Pcg32 random(static_cast<std::uint64_t>((y + 100) * 1000 + x + 100), index);
                const float size = std::ldexp(1.0f, static_cast<int>(random.next() % 40u) - 20);
                XYZ value{size * random.next_float(), size, size * random.next_float()};
                const std::uint32_t bad = random.next() % 11u;
                if (bad == 0) value.y = -value.y;
                if (bad == 1) value.x = std::numeric_limits<float>::infinity();
                if (bad == 2) value.z = std::bit_cast<float>(0xffc00000u + random.next() % 0x3fffffu);
                if (bad == 6) value = std::ldexp(1.0f, -50) / size * value;
                const float u = random.next_float(), v = random.next_float();
                const std::array<float, 3> seen = {bad == 5 ? std::nanf("") : u, -v, size};
                tile.set_sample_index(index);
                const SampledWavelengths<4> wavelengths{{410.0f, 500.0f, 555.5f, 650.0f},
                                                        {0.002f, 0.003f, 0.0025f, 0.002f}};
                SampledSpectrum<4> radiance;
                radiance.value = {value.x, value.y, value.z, size};
                const float at_x = static_cast<float>(x) + u, at_y = static_cast<float>(y) + v;
                if (options.filter_use == FilterUse::splatted) {
                    tile.add_at(at_x, at_y, value);
                    if (bad > 2) tile.add_at(at_x, at_y, wavelengths, radiance);
                } else {
                    const float weight = sampler.sample(u, v).weight;
                    tile.add(x, y, value, weight);
                    if (bad > 2) tile.add(x, y, wavelengths, radiance, weight);
                }
                for (std::size_t layer = 0; layer < options.aux.size(); ++layer) {
                    const std::span<const float> values(seen.data(), options.aux[layer].components.size());
                    if (options.filter_use == FilterUse::splatted) {
                        tile.add_aux_at(at_x, at_y, layer, values);
                    } else {
                        tile.add_aux(x, y, layer, values, 1.0f);
                    }
                }
                if (options.light_splats) tile.splat(at_x, at_y, wavelengths, radiance);
            }
        }
    }
    film.merge(tile);
    if (options.light_splats) film.add_light_paths(1000 * (end - begin));
}

inline FilmProvenance provenance(std::uint64_t begin, std::uint64_t end) {
    FilmProvenance from{.scene = "scene 0123456789abcdef", .sampling = "sobol seed 7\nwavelengths 4"};
    if (begin < end) from.samples.add(SampleRange{begin, end});
    return from;
}

inline FilmState state_with(const FilmOptions& options, std::uint64_t begin, std::uint64_t end) {
    Film film(options);
    add_samples(film, begin, end);
    return state_of(film, provenance(begin, end), {.seed = 7, .renderer_version = "test", .command_line = "a 'b c'"});
}

}  // namespace emulsion::testing
