#include "display/dither.h"

#include <stdexcept>
#include <string>

#include "core/named_value.h"
#include "display/component_rows.h"

namespace emulsion {

namespace {

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

template <class Pixel>
void check(const Dither& dither, ImageView<Pixel> picture, int threads) {
    validate_named(dither, "dither");
    if (threads < 0) throw std::invalid_argument("threads " + std::to_string(threads) + ": must be at least 0");
    if (picture.width() >= 1 && picture.height() >= 1) return;
    throw std::invalid_argument("picture size " + size_text(picture.width(), picture.height()) +
                                ": both must be at least 1");
}

template <class Pixel, class Code>
void check(const Dither& dither, ImageView<Pixel> encoded, ImageView<Code> codes, int threads) {
    check(dither, encoded, threads);
    if (codes.width() == encoded.width() && codes.height() == encoded.height()) return;
    throw std::invalid_argument("codes size " + size_text(codes.width(), codes.height()) + ": must be " +
                                size_text(encoded.width(), encoded.height()) + ", as the picture's");
}

void quantize_rows(const Dither& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
                   int threads) {
    std::visit([&](const auto& chosen) { quantize(chosen, source, scale, codes, threads); }, dither);
}

}  // namespace

void quantize_into(const Dither& dither, ImageView<const RGB> encoded, const CodeScale& scale, ImageView<CodeRGB> codes,
                   int threads) {
    check(dither, encoded, codes, threads);
    quantize_rows(dither, rgb_rows(encoded), scale, rgb_rows(codes), threads);
}

void quantize_into(const Dither& dither, ImageView<const float> encoded, const CodeScale& scale,
                   ImageView<std::uint16_t> codes, int threads) {
    check(dither, encoded, codes, threads);
    quantize_rows(dither, grey_rows(encoded), scale, grey_rows(codes), threads);
}

void quantize_into(const Dither& dither, const MakeEncoded& make, const CodeScale& scale, ImageView<CodeRGB> codes,
                   int threads) {
    check(dither, codes, threads);
    quantize_rows(dither, EncodedSource(codes.width(), codes.height(), make), scale, rgb_rows(codes), threads);
}

Image<CodeRGB> quantize(const Dither& dither, ImageView<const RGB> encoded, const CodeScale& scale, int threads) {
    check(dither, encoded, threads);
    Image<CodeRGB> codes(encoded.width(), encoded.height(), UnsetPixels{});
    quantize_into(dither, encoded, scale, codes.view(), threads);
    return codes;
}

Image<std::uint16_t> quantize(const Dither& dither, ImageView<const float> encoded, const CodeScale& scale,
                              int threads) {
    check(dither, encoded, threads);
    Image<std::uint16_t> codes(encoded.width(), encoded.height(), UnsetPixels{});
    quantize_into(dither, encoded, scale, codes.view(), threads);
    return codes;
}

}  // namespace emulsion
