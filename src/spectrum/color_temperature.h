#pragma once
// Correlated colour temperature: of the blackbody that a light looks most like.
//
// Defined in CIE 1960 u, v, where the nearest point of the Planckian locus is sought. The CIE takes the temperature as
// meaningful up to a distance of 0.05.

#include <array>
#include <optional>
#include <vector>

#include "spectrum/chromaticity.h"
#include "spectrum/observer.h"

namespace emulsion {

/// Beyond this distance from the Planckian locus a correlated colour temperature means nothing.
/// Source: CIE 15:2004, section 9.5.
inline constexpr double kLargestDuv = 0.05;

struct CorrelatedColorTemperature {
    double temperature_K = 0.0;
    /// Distance from the Planckian locus in CIE 1960 u, v: positive above it (greenish), negative below (pinkish).
    double duv = 0.0;
};

/// The chromaticities of blackbodies from 500 K to 1e6 K, by the constants of the SI (2019). With the rounded second
/// radiation constant 1.4388e-2 m K of CIE 15:2004 temperatures come out 0.0016% higher.
class PlanckianLocus {
  public:
    static constexpr double kColdest_K = 500.0;
    static constexpr double kHottest_K = 1e6;

    explicit PlanckianLocus(const Observer& observer);

    /// By integration over the observer's range, exact to 1e-13.
    /// \throws std::invalid_argument if the temperature is outside [kColdest_K, kHottest_K].
    [[nodiscard]] Uv1960 uv(double temperature_K) const;

    /// The colour at a distance duv from the locus, square to it: the inverse of nearest() for |duv| <= kLargestDuv.
    /// \throws std::invalid_argument as above, or if duv is not finite.
    [[nodiscard]] Uv1960 uv(const CorrelatedColorTemperature& temperature) const;

    /// The nearest point of the locus, exact: a blackbody gets its temperature back to a relative 1e-9 and duv = 0 to
    /// 1e-12. Also returned beyond kLargestDuv: the caller compares. Unset where the nearest point is an end of the
    /// locus (redder than 500 K, bluer than 1e6 K), and for chromaticities that are not finite.
    /// Source: CIE 15:2004, section 9.5; the sign of duv: ANSI C78.377-2008.
    [[nodiscard]] std::optional<CorrelatedColorTemperature> nearest(const Uv1960& uv) const noexcept;

  private:
    // A point of the locus and its first two derivatives by reciprocal temperature, in mired: 1e6 K / T.
    struct Point {
        Uv1960 uv, slope, curvature;
    };
    // An abscissa of the integrals over wavelength, with its weights.
    struct Abscissa {
        double exponent;               // of Planck's law, per mired
        std::array<double, 3> weight;  // for u's numerator, v's numerator, and their denominator
    };

    [[nodiscard]] Point at(double mired) const noexcept;

    std::vector<Abscissa> abscissae_;
    std::vector<double> node_mired_;  // increasing
    std::vector<Uv1960> node_uv_;
};

/// The locus of cie_1931_2deg(), made on first use (about 10 ms). May be called from many threads.
[[nodiscard]] const PlanckianLocus& cie_1931_planckian_locus();

/// cie_1931_planckian_locus().nearest, of CIE 1931 x and y.
[[nodiscard]] std::optional<CorrelatedColorTemperature> correlated_color_temperature(const Chromaticity& chromaticity);

}  // namespace emulsion
