#pragma once
// How noisy the pixels of a scene are by a transport model, as its pilot tells.

#include <vector>

#include "analysis/pilot.h"
#include "analysis/pixel_noise.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/transport_model.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion {

/// Knows some pixels of a pilot, evenly spread.
class NoisePrediction {
  public:
    /// Keeps a reference to the scene.
    NoisePrediction(const PreparedScene& scene, const Pilot& pilot, const ViewingConditions& viewing,
                    const PilotOptions& options);

    /// Root mean square CIEDE2000 of a pixel of `samples` paths of a model that the scene is prepared for: what their
    /// luminance and their wavelengths make of it.
    [[nodiscard]] double operator()(const TransportModel& model, double samples) const;

  private:
    struct Pixel {
        PixelLight light;
        std::vector<double> ratio;  // to the scene's light
    };
    const PreparedScene& scene_;
    ViewingConditions viewing_;
    PixelPaths::Numbers numbers_;
    int threads_;
    Spectrum light_;
    std::vector<Pixel> pixels_;
};

}  // namespace emulsion
