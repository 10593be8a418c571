#include "display/color_encoding.h"

namespace emulsion {

ColorEncoding color_encoding(const Display& display, const TransferFunction& transfer, const CodeRange& range) {
    return {rgb_space(display), transfer, range};
}

}  // namespace emulsion
