#pragma once
// Quantization with dithering: from encoded RGB in [0, 1] to code values.

#include <cstdint>
#include <variant>

#include "core/color.h"
#include "core/image.h"
#include "display/bayer.h"
#include "display/blue_noise.h"
#include "display/code_value.h"
#include "display/encoded_source.h"
#include "display/error_diffusion.h"
#include "display/halftone.h"
#include "display/no_dither.h"
#include "display/noise_dither.h"

namespace emulsion {

/// All ways to dither.
using Dither = std::variant<NoDither, WhiteNoise, TriangularNoise, Bayer, BlueNoise, Halftone, FloydSteinberg, Jarvis,
                            Stucki, Sierra, Atkinson>;

/// Encoded 0 becomes the scale's black, and 1 its white, exactly; no code outside of these is made. Components outside
/// [0, 1] are taken as the nearest value inside, NaN as 0. The same codes for every number of threads (0: all).
/// \throws std::invalid_argument if the picture is empty, a parameter is out of its range, or threads < 0.
[[nodiscard]] Image<CodeRGB> quantize(const Dither& dither, ImageView<const RGB> encoded, const CodeScale& scale,
                                      int threads);

/// The same for one channel.
[[nodiscard]] Image<std::uint16_t> quantize(const Dither& dither, ImageView<const float> encoded,
                                            const CodeScale& scale, int threads);

/// The same into pixels that exist. \throws std::invalid_argument as above, or if the sizes differ.
void quantize_into(const Dither& dither, ImageView<const RGB> encoded, const CodeScale& scale, ImageView<CodeRGB> codes,
                   int threads);
void quantize_into(const Dither& dither, ImageView<const float> encoded, const CodeScale& scale,
                   ImageView<std::uint16_t> codes, int threads);

/// The same of encoded values that are made when they are asked for, as many as `codes` has pixels: stages before this
/// one then hand on what is in the processor's cache. Only Hilbert order has to have all of them in memory.
/// \param make must give the same for every number of threads \throws std::invalid_argument as above; what `make`
/// throws.
void quantize_into(const Dither& dither, const MakeEncoded& make, const CodeScale& scale, ImageView<CodeRGB> codes,
                   int threads);

}  // namespace emulsion
