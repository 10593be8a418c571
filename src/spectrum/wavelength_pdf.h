#pragma once
// Densities that wavelengths are drawn from, over [kMinWavelength_nm, kMaxWavelength_nm], in 1/nm. Each offers
//   exact(u)      u in [0, 1) to a wavelength and its density, by the inverse of the distribution function; double
//                 precision, the specification
//   sample(u)     the same in single precision, for the inner loop: within 1e-4 nm and a relative 1e-6 of exact(u)
//   pdf(lambda)   the density at a wavelength, 0 outside the range
// In order of what they know: nothing (here), the eye (here), the eye and the scene's light (wavelength_table.h), and
// its lines too (wavelength_lines.h).

#include <cmath>

#include "core/units.h"

namespace emulsion {

/// One wavelength with the density it was drawn with, 1/nm.
struct WavelengthSample {
    float lambda_nm, pdf;
};

/// The same in double precision.
struct ExactWavelengthSample {
    double lambda_nm, pdf;
};

/// The same density everywhere.
class UniformWavelengthPdf {
  public:
    [[nodiscard]] ExactWavelengthSample exact(double u) const noexcept {
        return {kMinWavelength_nm + u * kRange_nm, 1.0 / kRange_nm};
    }
    [[nodiscard]] WavelengthSample sample(double u) const noexcept {
        const ExactWavelengthSample rounded = exact(u);
        return {static_cast<float>(rounded.lambda_nm), static_cast<float>(rounded.pdf)};
    }
    [[nodiscard]] double pdf(double lambda_nm) const noexcept {
        return lambda_nm >= kMinWavelength_nm && lambda_nm <= kMaxWavelength_nm ? 1.0 / kRange_nm : 0.0;
    }

  private:
    static constexpr double kRange_nm = kMaxWavelength_nm - kMinWavelength_nm;
};

/// Density p(lambda) proportional to sech^2(a (lambda - b)) over the visible range, close to the sum of the
/// colour-matching functions: fewer samples fall where the eye is all but blind. Source: Radziszewski, Boryczko & Alda,
/// "An Improved Technique for Full Spectral Rendering", WSCG 2009, eq. 4; here with the normalisation worked out for
/// [360, 830] nm.
class VisibleWavelengthPdf {
  public:
    VisibleWavelengthPdf() noexcept
        : tanh_min_(std::tanh(kSteepness * (kMinWavelength_nm - kCentre_nm))),
          tanh_range_(std::tanh(kSteepness * (kMaxWavelength_nm - kCentre_nm)) - tanh_min_) {}

    /// The inverse of the distribution function: u in [0, 1) to nm.
    [[nodiscard]] double sample_nm(double u) const noexcept {
        return kCentre_nm + std::atanh(tanh_min_ + u * tanh_range_) / kSteepness;
    }

    /// 1/nm; 0 outside the range.
    [[nodiscard]] double pdf(double lambda_nm) const noexcept {
        if (!(lambda_nm >= kMinWavelength_nm && lambda_nm <= kMaxWavelength_nm)) return 0.0;
        const double t = std::tanh(kSteepness * (lambda_nm - kCentre_nm));
        return kSteepness * (1.0 - t * t) / tanh_range_;
    }

    [[nodiscard]] ExactWavelengthSample exact(double u) const noexcept {
        const double t = tanh_min_ + u * tanh_range_;
        return {sample_nm(u), kSteepness * (1.0 - t * t) / tanh_range_};
    }

    /// The density needs no second tanh.
    [[nodiscard]] WavelengthSample sample(double u) const noexcept {
        const double t = tanh_min_ + u * tanh_range_;
        const float twice_atanh = std::log(static_cast<float>((1.0 + t) / (1.0 - t)));
        return {static_cast<float>(kCentre_nm) + twice_atanh * static_cast<float>(0.5 / kSteepness),
                static_cast<float>(kSteepness * (1.0 - t * t) / tanh_range_)};
    }

  private:
    static constexpr double kSteepness = 0.0072;  // 1/nm
    static constexpr double kCentre_nm = 538.0;

    double tanh_min_, tanh_range_;
};

}  // namespace emulsion
