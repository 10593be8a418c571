#pragma once
// A curve through all pixels of a picture.

#include <vector>

namespace emulsion {

struct PixelPlace {
    int x, y;
    bool operator==(const PixelPlace&) const = default;
};

/// All pixels of width x height (both at least 1), each once, along a generalised Hilbert curve from the top left: each
/// is beside the one before it, or in a corner of it where no such curve exists (some odd sizes).
/// Source: the recursion of Cerveny's "gilbert" (2018), which halves a rectangle that is more than 1.5 times as long as
/// wide, and cuts others into three as Hilbert's curve does.
[[nodiscard]] std::vector<PixelPlace> hilbert_curve(int width, int height);

}  // namespace emulsion
