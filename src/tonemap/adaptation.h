#pragma once
// The choice of an adaptation luminance, which every operator can be given.

#include <variant>

#include "core/color.h"
#include "core/image.h"
#include "core/named_value.h"
#include "tonemap/adaptation_luminance.h"
#include "tonemap/bilateral.h"
#include "tonemap/centre_surround.h"
#include "tonemap/global_adaptation.h"
#include "tonemap/scene_luminance.h"
#include "tonemap/uniform_radius.h"
#include "tonemap/varying_radius.h"

namespace emulsion {

/// All adaptations; the first is the default of most operators. core/named_value.h prints, parses and lists them.
using Adaptation =
    std::variant<LogAverageAdaptation, AverageAdaptation, MedianAdaptation, CentreWeightedAdaptation, SpotAdaptation,
                 UniformRadiusAdaptation, VaryingRadiusAdaptation, CentreSurroundAdaptation, BilateralAdaptation>;

/// Whether each pixel has an adaptation of its own.
[[nodiscard]] bool is_local(const Adaptation& adaptation) noexcept;

/// Of a picture that has positive pixels. The same bits for every number of threads (0: all).
/// \throws std::invalid_argument if threads < 0.
[[nodiscard]] AdaptationLuminance adapt(const Adaptation& adaptation, ImageView<const XYZ> scene,
                                        const SceneLuminance& luminance, int threads);

/// The double-precision twin, on one thread: local adaptations pixel by pixel as their source has them.
[[nodiscard]] BasicAdaptationLuminance<double> adapt_reference(const Adaptation& adaptation, ImageView<const XYZ> scene,
                                                               const SceneLuminance& luminance);

}  // namespace emulsion
