#include "display/code_value.h"

namespace emulsion {

CodeScale code_scale(int bits, const CodeRange& range) {
    check_range(bits, kCodeBits, "bits");
    if (std::holds_alternative<FullRange>(range)) return {0, (1 << bits) - 1};
    check_range(bits, {8.0, 16.0}, "bits of the narrow range");
    return {16 << (bits - 8), 235 << (bits - 8)};
}

}  // namespace emulsion
