#pragma once
// Error diffusion in rows, fast: to the bit the same codes as diffuse_plainly().

#include "display/code_value.h"
#include "display/component_rows.h"
#include "display/diffuse_plainly.h"
#include "display/diffusion_kernel.h"
#include "display/encoded_source.h"

namespace emulsion {

/// Rounds all of all channels. Raster order uses up to `threads` threads (0: all): each takes the next row, and follows
/// the row above it at a distance. Serpentine uses one, since a row begins where the one above it ends.
/// Instead of handing errors down, every row keeps its own, and gathers its values' shares of those of the rows above,
/// many at a time; only what is handed on within the row is done pixel by pixel. Pixels near the left and right border,
/// whose errors are split otherwise, hand theirs down; the last rows are left to diffuse_plainly(), as are pictures of
/// less than 8 columns and of more than 2^15 rows.
/// For the kernels in display/diffusion_kernel.h, and one or three channels.
template <const DiffusionKernel& Kernel>
void diffuse_rows(RowOrder order, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
                  int threads);

}  // namespace emulsion
