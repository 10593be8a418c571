#include "film/spectral_buckets.h"

#include "core/parameters.h"

namespace emulsion {

void validate(const SpectralBuckets& buckets) {
    check_range(buckets.count, {1, 1024}, "film: spectrum.count");
    constexpr double kMin_nm = 100.0, kMax_nm = 1000.0, kLeastWidth_nm = 0.01;
    check_range(buckets.max_nm, {kMin_nm, kMax_nm, RangeEnd::open}, "film: spectrum.max_nm");
    check_range(buckets.min_nm, {kMin_nm, buckets.max_nm, RangeEnd::closed, RangeEnd::open}, "film: spectrum.min_nm");
    check_range(buckets.width_nm(), {kLeastWidth_nm, kMax_nm}, "film: spectrum: width of a bucket in nm");
}

}  // namespace emulsion
