#include "spectrum/spectrum_table.h"

#include <cmath>
#include <stdexcept>

#include <fmt/core.h>

namespace emulsion {

SpectrumTable::SpectrumTable(const Spectrum& spectrum, double scale) {
    validate(spectrum);
    lines_.reserve(kMaxWavelength_nm - kMinWavelength_nm);
    for (int lambda_nm = kMinWavelength_nm; lambda_nm < kMaxWavelength_nm; ++lambda_nm) {
        // Limits from inside the cell, so that a jump at a whole nanometre stays a jump.
        const double start = scale * limit(spectrum, lambda_nm, Side::above);
        const double end = scale * limit(spectrum, lambda_nm + 1, Side::below);
        const Line line{static_cast<float>(start), static_cast<float>(end - start)};
        if (!std::isfinite(line.start) || !std::isfinite(line.slope)) {
            throw std::invalid_argument(fmt::format(
                "spectrum times {} is {} at {} nm and {} at {} nm: expected finite numbers of single precision", scale,
                start, lambda_nm, end, lambda_nm + 1));
        }
        lines_.push_back(line);
    }
}

}  // namespace emulsion
