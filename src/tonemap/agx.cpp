#include "tonemap/agx.h"

#include <cmath>
#include <numbers>

#include "core/middle_grey.h"

namespace emulsion {

namespace {

constexpr double kStopsBelow = 10.0, kStopsAbove = 6.5, kStops = kStopsBelow + kStopsAbove;
constexpr double kPivot = kStopsBelow / kStops, kPivotValue = 0.5, kSlope = 2.0;
constexpr double kToePower = 3.0, kShoulderPower = 3.25, kDisplayPower = 2.2;
constexpr double kTailStops = 2.0;  // above x = 0, where the tail begins

/// One side of the sigmoid: at kPivot its value is 1/2 and its slope kSlope, a distance `reach` from there 1/2 more.
class Branch {
  public:
    Branch(double reach, double power) noexcept
        : power_(power), bend_((std::pow(kSlope * reach / kPivotValue, power) - 1.0) / std::pow(reach, power)) {}

    /// How far the value is from 1/2 at a distance from the pivot, and its slope there.
    [[nodiscard]] double rise(double distance) const noexcept {
        return kSlope * distance * std::pow(bent(distance), -1.0 / power_);
    }
    [[nodiscard]] double slope(double distance) const noexcept {
        return kSlope * std::pow(bent(distance), -1.0 / power_ - 1.0);
    }

  private:
    [[nodiscard]] double bent(double distance) const noexcept { return 1.0 + bend_ * std::pow(distance, power_); }

    double power_, bend_;
};

/// Ld / L.
class Curve {
  public:
    [[nodiscard]] double operator()(double scaled) const noexcept {
        if (scaled < tail_scaled_) {
            return tail_shown_ / tail_scaled_ * std::pow(scaled / tail_scaled_, tail_power_ - 1.0);
        }
        const double distance = std::log2(scaled / kMiddleGrey) / kStops;  // from the pivot
        const double rise = distance < 0.0 ? -toe_.rise(-distance) : shoulder_.rise(distance);
        return std::pow(kPivotValue + rise, kDisplayPower) / scaled;
    }

  private:
    static constexpr double kTailBegins = kTailStops / kStops;  // in x

    Branch toe_{kPivot, kToePower}, shoulder_{1.0 - kPivot, kShoulderPower};
    double tail_scaled_ = kMiddleGrey * std::exp2(kTailStops - kStopsBelow);
    double tail_value_ = kPivotValue - toe_.rise(kPivot - kTailBegins);
    double tail_shown_ = std::pow(tail_value_, kDisplayPower);
    /// d ln(Ld) / d ln(L).
    double tail_power_ = kDisplayPower * toe_.slope(kPivot - kTailBegins) / (tail_value_ * kStops * std::numbers::ln2);
};

}  // namespace

Adaptation own_adaptation(const AgX&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const AgX& mapper, const SceneLuminance&, double) {
    return {.exposure = [key = double{mapper.key}](double adaptation) { return key / adaptation; },
            .compression = Curve{}};
}

}  // namespace emulsion
