#include "display/color_encoding.h"

#include <variant>

namespace emulsion {

namespace {

const RgbSpace& space_of(const SrgbDisplay& /*display*/) { return rgb_space("sRGB"); }

}  // namespace

ColorEncoding color_encoding(const Display& display, const TransferFunction& transfer, const CodeRange& range) {
    return {std::visit([](const auto& shown) { return space_of(shown); }, display), transfer, range};
}

}  // namespace emulsion
