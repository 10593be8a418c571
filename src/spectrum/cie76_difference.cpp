#include "spectrum/cie76_difference.h"

#include <cmath>

namespace emulsion {

double difference(const Cie76Difference& /*method*/, const Lab& reference, const Lab& sample) noexcept {
    // Not the hypot of three, which loses a NaN among them in libstdc++ 12.
    const double dl = reference.l - sample.l, da = reference.a - sample.a, db = reference.b - sample.b;
    return std::sqrt(dl * dl + da * da + db * db);
}

}  // namespace emulsion
