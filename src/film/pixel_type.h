#pragma once

namespace emulsion {

/// How a channel is stored in a file: IEEE 754 binary32, or binary16 (largest value 65504).
enum class PixelType { float32, half };

}  // namespace emulsion
