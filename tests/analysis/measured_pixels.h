#pragma once
// Some pixels of a scene's film by one transport model, as render() has them: measured, to compare predictions with.
//
// A path draws its numbers from the same sequence whatever its model, so that pictures of one seed by two models go the
// same ways: their difference has little of the paths' own noise.

#include <cstdint>
#include <utility>
#include <vector>

#include "core/color.h"
#include "pathtracer/prepared_scene.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion::test {

using PixelPlaces = std::vector<std::pair<int, int>>;

/// About `count` pixels of the whole frame: one of each cell of an even grid, anywhere in it.
PixelPlaces spread_pixels(const Scene& scene, int count, std::uint64_t seed);

/// Their XYZ by `samples` paths each. Prepares the scene for the model.
std::vector<XYZd> measured_pixels(PreparedScene& scene, const TransportModel& model, const PixelPlaces& places,
                                  int samples, std::uint64_t seed);

/// Root mean square CIEDE2000 of one picture from its mean: that between two of different seeds over sqrt(2).
double measured_noise(PreparedScene& scene, const TransportModel& model, const PixelPlaces& places, int samples);

/// As the pilot looks at a picture.
ViewingConditions viewing_of(const std::vector<XYZd>& pixels);

/// Two pictures by a model and two of the reference, of the same two seeds.
struct MeasuredError {
    double mean = 0.0, p99 = 0.0;              ///< CIEDE2000 between the means of the two; with the noise that is left
    double noise_mean = 0.0, noise_p99 = 0.0;  ///< of the noise alone, by the difference of the two
};
MeasuredError measured_error(PreparedScene& scene, const TransportModel& model, const TransportModel& reference,
                             const PixelPlaces& places, int samples);

}  // namespace emulsion::test
