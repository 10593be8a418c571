#include "display/dither.h"

#include <stdexcept>
#include <string>

namespace emulsion {

namespace {

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

void check(ImageView<const RGB> encoded, int threads) {
    if (threads < 0) throw std::invalid_argument("threads " + std::to_string(threads) + ": must be at least 0");
    if (encoded.width() >= 1 && encoded.height() >= 1) return;
    throw std::invalid_argument("picture size " + size_text(encoded.width(), encoded.height()) +
                                ": both must be at least 1");
}

}  // namespace

void quantize_into(const Dither& dither, ImageView<const RGB> encoded, const CodeScale& scale, ImageView<CodeRGB> codes,
                   int threads) {
    check(encoded, threads);
    if (codes.width() != encoded.width() || codes.height() != encoded.height()) {
        throw std::invalid_argument("codes size " + size_text(codes.width(), codes.height()) + ": must be " +
                                    size_text(encoded.width(), encoded.height()) + ", as the picture's");
    }
    std::visit([&](const auto& chosen) { quantize(chosen, encoded, scale, codes, threads); }, dither);
}

Image<CodeRGB> quantize(const Dither& dither, ImageView<const RGB> encoded, const CodeScale& scale, int threads) {
    check(encoded, threads);
    Image<CodeRGB> codes(encoded.width(), encoded.height());
    quantize_into(dither, encoded, scale, codes.view(), threads);
    return codes;
}

}  // namespace emulsion
