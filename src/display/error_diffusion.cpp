#include "display/error_diffusion.h"

#include "display/diffuse_hilbert.h"
#include "display/diffuse_rows.h"

namespace emulsion {

namespace {

template <const DiffusionKernel& Kernel>
void diffuse(int scan, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes, int threads) {
    if (scan == kHilbertScan) return diffuse_hilbert(Kernel, encoded, scale, codes);
    const RowOrder order = scan == kSerpentineScan ? RowOrder::serpentine : RowOrder::raster;
    diffuse_rows<Kernel>(order, encoded, scale, codes, threads);
}

}  // namespace

void quantize(const FloydSteinberg& dither, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kFloydSteinbergKernel>(dither.scan, encoded, scale, codes, threads);
}
void quantize(const Jarvis& dither, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kJarvisKernel>(dither.scan, encoded, scale, codes, threads);
}
void quantize(const Stucki& dither, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kStuckiKernel>(dither.scan, encoded, scale, codes, threads);
}
void quantize(const Sierra& dither, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kSierraKernel>(dither.scan, encoded, scale, codes, threads);
}
void quantize(const Atkinson& dither, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    diffuse<kAtkinsonKernel>(dither.scan, encoded, scale, codes, threads);
}

}  // namespace emulsion
