#include "display/png_compression.h"

#include <png.h>
#include <zlib.h>

namespace emulsion {

PngCompression png_compression(int level, int code_bits) {
    constexpr int kPatternBits = 4;
    check_range(level, kPngLevels, "PNG level");
    if (level == 0) return {0, Z_DEFAULT_STRATEGY, PNG_FILTER_NONE};
    if (code_bits <= kPatternBits) return {level == 2 ? 3 : level, Z_DEFAULT_STRATEGY, PNG_FILTER_NONE};
    if (level == 1) return {1, Z_RLE, PNG_FILTER_SUB};
    if (level == 2) return {1, Z_RLE, PNG_FILTER_PAETH};
    if (level == 3) return {1, Z_RLE, PNG_ALL_FILTERS};
    return {level, Z_FILTERED, PNG_ALL_FILTERS};
}

}  // namespace emulsion
