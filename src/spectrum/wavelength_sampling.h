#pragma once
// Drawing the wavelengths of a path.

#include <cmath>

#include "core/units.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

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
        if (lambda_nm < kMinWavelength_nm || lambda_nm > kMaxWavelength_nm) return 0.0;
        const double t = std::tanh(kSteepness * (lambda_nm - kCentre_nm));
        return kSteepness * (1.0 - t * t) / tanh_range_;
    }

    /// One wavelength with its density.
    struct Sample {
        float lambda_nm, pdf;
    };

    /// sample_nm(u) and pdf() there in one: the density needs no second tanh. Within 1e-4 nm of the twins, and a
    /// relative 1e-6.
    [[nodiscard]] Sample sample(double u) const noexcept {
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

/// Draws N wavelengths from one uniform number u in [0, 1): the first by inverting the distribution, the others by
/// rotating u by 1/N each, so that every stratum holds one ("hero wavelength" sampling).
/// Source: Wilkie et al., "Hero Wavelength Spectral Sampling", EGSR 2014.
template <int N>
[[nodiscard]] SampledWavelengths<N> sample_visible_wavelengths(const VisibleWavelengthPdf& distribution,
                                                               float u) noexcept {
    SampledWavelengths<N> wavelengths;
    for (int i = 0; i < N; ++i) {
        double rotated = static_cast<double>(u) + static_cast<double>(i) / N;
        if (rotated >= 1.0) rotated -= 1.0;
        const VisibleWavelengthPdf::Sample sample = distribution.sample(rotated);
        wavelengths.lambda_nm[static_cast<std::size_t>(i)] = sample.lambda_nm;
        wavelengths.pdf[static_cast<std::size_t>(i)] = sample.pdf;
    }
    return wavelengths;
}

}  // namespace emulsion
