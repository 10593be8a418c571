#include "display/error_diffusion.h"

#include "display/diffuse_hilbert.h"
#include "display/diffuse_rows.h"

namespace emulsion {

namespace {

template <const DiffusionKernel& Kernel>
void diffuse(int scan, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes, int threads) {
    if (scan == kHilbertScan) {
        return diffuse_hilbert(Kernel, EncodedPicture(source, 0, threads).rows(), scale, codes);
    }
    const RowOrder order = scan == kSerpentineScan ? RowOrder::serpentine : RowOrder::raster;
    diffuse_rows<Kernel>(order, source, scale, codes, threads);
}

}  // namespace

void quantize(const FloydSteinberg& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kFloydSteinbergKernel>(dither.scan, source, scale, codes, threads);
}
void quantize(const Jarvis& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kJarvisKernel>(dither.scan, source, scale, codes, threads);
}
void quantize(const Stucki& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kStuckiKernel>(dither.scan, source, scale, codes, threads);
}
void quantize(const Sierra& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kSierraKernel>(dither.scan, source, scale, codes, threads);
}
void quantize(const Atkinson& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kAtkinsonKernel>(dither.scan, source, scale, codes, threads);
}

}  // namespace emulsion
