#include "film/spectral_buckets.h"

#include "core/parameters.h"

namespace emulsion {

void validate(const SpectralBuckets& buckets) {
    check_range(buckets.count, {1, 1024}, "film: spectrum.count");
    check_range(buckets.max_nm, {0.0, 1e6, RangeEnd::open}, "film: spectrum.max_nm");
    check_range(buckets.min_nm, {0.0, buckets.max_nm, RangeEnd::open, RangeEnd::open}, "film: spectrum.min_nm");
}

}  // namespace emulsion
