#include "spectrum/ycbcr.h"

namespace emulsion {

namespace {

/// B' - Y' over this is in [-0.5, 0.5], as B' - Y' is in [kb - 1, 1 - kb].
constexpr double divisor(double weight) noexcept { return 2.0 * (1.0 - weight); }

}  // namespace

Ycbcr ycbcr_from_rgb(const LumaWeights& weights, const YcbcrRange& range, const RGBd& encoded) noexcept {
    const LumaDifferences of = luma_differences_of(weights, encoded);
    return {range.luma_scale * of.luma + range.luma_offset,
            range.chroma_scale * of.blue_minus / divisor(weights.kb) + range.chroma_offset,
            range.chroma_scale * of.red_minus / divisor(weights.kr) + range.chroma_offset};
}

RGBd rgb_from_ycbcr(const LumaWeights& weights, const YcbcrRange& range, const Ycbcr& ycbcr) noexcept {
    return rgb_of(weights, {(ycbcr.luma - range.luma_offset) / range.luma_scale,
                            (ycbcr.cb - range.chroma_offset) / range.chroma_scale * divisor(weights.kb),
                            (ycbcr.cr - range.chroma_offset) / range.chroma_scale * divisor(weights.kr)});
}

}  // namespace emulsion
