#include "tonemap/fixed_white.h"

namespace emulsion {

Adaptation own_adaptation(const FixedWhite&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const FixedWhite& mapper, const SceneLuminance&, double) {
    return {.exposure = [scale = double{mapper.scale} / mapper.white](double) { return scale; }};
}

}  // namespace emulsion
