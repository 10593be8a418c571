#pragma once
// A spectrum at each pixel: samples sorted into buckets of equal width by their wavelengths.
//
// A wavelength drawn with density p, one of N, covers 1 / (N p width) of its bucket: 1 in the mean, for a bucket within
// the range that wavelengths are drawn from. A bucket's mean radiance is sum(w L coverage) / sum(w coverage). That is
// as good as free of the noise of how many wavelengths happen to fall into it, and biased only as ratios of means are,
// by the order of 1 / samples.

#include <algorithm>
#include <cstddef>
#include <span>

namespace emulsion {

/// `count` buckets over [min_nm, max_nm).
struct SpectralBuckets {
    int count = 32;         ///< in [1, 1024]
    double min_nm = 380.0;  ///< in [100, max_nm)
    double max_nm = 780.0;  ///< at most 1000: files name buckets by three digits and three decimals
    bool operator==(const SpectralBuckets&) const = default;

    [[nodiscard]] double width_nm() const noexcept { return (max_nm - min_nm) / count; }
    [[nodiscard]] double centre_nm(int bucket) const noexcept { return min_nm + (bucket + 0.5) * width_nm(); }
};

/// \throws std::invalid_argument naming the field, its value and its range; also for buckets narrower than 0.01 nm.
void validate(const SpectralBuckets& buckets);

/// The wavelengths of one path, and what it carries at each: spans of one length.
struct SpectralSample {
    std::span<const float> lambda_nm;  ///< nm
    std::span<const float> radiance;   ///< W m^-2 sr^-1 nm^-1
    std::span<const float> pdf;        ///< 1/nm; 0: the wavelength has ended and carries nothing
};

/// Calls visit(bucket, radiance, coverage) for each wavelength that falls into one.
template <class Visit>
void for_each_bucket(const SpectralSample& sample, const SpectralBuckets& buckets, const Visit& visit) noexcept {
    const double per_nm = 1.0 / buckets.width_nm();
    for (std::size_t k = 0; k < sample.lambda_nm.size(); ++k) {
        const auto lambda_nm = static_cast<double>(sample.lambda_nm[k]), pdf = static_cast<double>(sample.pdf[k]);
        const bool is_inside = lambda_nm >= buckets.min_nm && lambda_nm < buckets.max_nm && pdf > 0.0;
        if (!is_inside) continue;
        // Rounding may put the last numbers below max_nm one bucket too far.
        const int bucket = std::min(static_cast<int>((lambda_nm - buckets.min_nm) * per_nm), buckets.count - 1);
        visit(static_cast<std::size_t>(bucket), static_cast<double>(sample.radiance[k]),
              per_nm / (pdf * static_cast<double>(sample.lambda_nm.size())));
    }
}

}  // namespace emulsion
