#include "display/curve_table.h"

namespace emulsion {

CurveTable::CurveTable(const std::function<double(double)>& curve, float smallest)
    : first_(std::bit_cast<std::uint32_t>(smallest) >> kFractionBits),
      last_((std::bit_cast<std::uint32_t>(1.0f) >> kFractionBits) - first_) {
    for (std::uint32_t i = first_; i < first_ + last_; ++i) {
        const double x0 = std::bit_cast<float>(i << kFractionBits);
        const double x1 = std::bit_cast<float>((i + 1) << kFractionBits);
        // The ends are rounded before the parabola is laid through them, so that segments meet without a step.
        const auto y0 = static_cast<float>(curve(x0));
        const auto y1 = static_cast<float>(curve(x1));
        const double rise = static_cast<double>(y1) - y0;
        const double square = 2.0 * (static_cast<double>(y0) + y1) - 4.0 * curve(0.5 * (x0 + x1));
        segments_.push_back({y0, static_cast<float>(rise - square), static_cast<float>(square), 0.0f});
    }
    segments_.push_back({static_cast<float>(curve(1.0)), 0.0f, 0.0f, 0.0f});
}

}  // namespace emulsion
