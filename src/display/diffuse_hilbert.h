#pragma once
// Error diffusion along a Hilbert curve.

#include "display/code_value.h"
#include "display/component_rows.h"
#include "display/diffusion_kernel.h"

namespace emulsion {

/// On one thread; display/error_diffusion.h says how. After Velho & Gomes, "Digital Halftoning with Space Filling
/// Curves", SIGGRAPH 1991, with a kernel instead of groups of pixels.
void diffuse_hilbert(const DiffusionKernel& kernel, const EncodedRows& encoded, const CodeScale& scale,
                     const CodeRows& codes);

}  // namespace emulsion
