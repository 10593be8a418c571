#pragma once
// The estimate of a caustic through a small light, without a path tracer: a number of infinite variance.

#include <cmath>
#include <cstdint>
#include <memory>

#include "core/random.h"
#include "film/film.h"

namespace emulsion::stability {

/// u^-a has the mean 1 / (1 - a) and, from a = 1/2 on, no variance: the tail that an estimate has where what is drawn
/// thins out faster than what it stands for.
inline constexpr float kCausticExponent = 0.75f;
inline constexpr double kCausticMean = 4.0;

inline XYZ caustic_sample(Pcg32& random) {
    const float u = (static_cast<float>(random.next() >> 8u) + 0.5f) * 0x1p-24f;
    const float value = std::pow(u, -kCausticExponent);
    return {value, value, value};
}

/// 32 x 32 pixels of it.
inline std::unique_ptr<Film> caustic_film(const FireflyControl& control, std::uint64_t samples) {
    auto film = std::make_unique<Film>(FilmOptions{.width_px = 32, .height_px = 32, .firefly_control = control});
    FilmTile tile = film->make_tile(film->bounds());
    Pcg32 random(11);
    for (std::uint64_t i = 0; i < samples; ++i) {
        tile.set_sample_index(i);
        for (int p = 0; p < 32 * 32; ++p) tile.add(p % 32, p / 32, caustic_sample(random), 1.0f);
    }
    film->merge(tile);
    return film;
}

}  // namespace emulsion::stability
