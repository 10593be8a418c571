#pragma once
// Blue-noise tiles by the void-and-cluster method.

#include <cstdint>
#include <vector>

namespace emulsion {

/// Ranks of a square tile that repeats without a seam, row by row: each of [0, size^2) once, such that the pixels of
/// rank below any number are spread evenly. `size` is from 2 to 256. The same ranks for the same size and seed.
/// A pixel's energy is the sum of a Gaussian of 1.5 pixels at all dots. Dots are moved from the tightest cluster (most
/// energy) to the largest void (least) until that changes nothing; from there ranks go down by taking out the tightest
/// cluster, and up by filling the largest void.
/// Energies are whole numbers, updated by one Gaussian a dot, and therefore exact. Where dots are so far apart that
/// this Gaussian has ended, another decides that is 8 times as wide and 2^-24 as high; this is ours.
/// Source: Ulichney, "The Void-and-Cluster Method for Dither Array Generation", Proc. SPIE 1913 (1993).
[[nodiscard]] std::vector<std::uint16_t> void_and_cluster(int size, std::uint64_t seed);

}  // namespace emulsion
