#pragma once
// What a film counts beside its pixels.

#include <cstdint>
#include <limits>

#include "film/clamped_samples.h"
#include "film/dropped_samples.h"

namespace emulsion {

struct FilmCounts {
    std::uint64_t samples = 0;       ///< camera samples, each counted once, without the dropped ones
    std::uint64_t light_splats = 0;  ///< light splats that arrived
    std::uint64_t light_paths = 0;   ///< light paths traced; at its end, 2^64 - 1, it stays
    std::uint64_t dropped_aux = 0;   ///< values of auxiliary layers that were not finite
    /// Camera samples and light splats whose luminance, before any clamp, is above 0 and at most half of ExactSum's
    /// resolution, 2.8e-14 cd/m^2 (times the imaging ratio): they were added, as what they round to. At a weight of 1
    /// that is 0.
    std::uint64_t faint = 0;
    DroppedSamples dropped;  ///< camera samples and light splats that were kept out
    ClampedSamples clamped;  ///< samples that LuminanceClamp scaled down
    bool operator==(const FilmCounts&) const = default;

    void add_light_paths(std::uint64_t paths) noexcept {
        const std::uint64_t sum = light_paths + paths;
        light_paths = sum < paths ? std::numeric_limits<std::uint64_t>::max() : sum;
    }

    void merge(const FilmCounts& other) noexcept {
        samples += other.samples;
        light_splats += other.light_splats;
        add_light_paths(other.light_paths);
        dropped_aux += other.dropped_aux;
        faint += other.faint;
        dropped.merge(other.dropped);
        clamped.merge(other.clamped);
    }
};

}  // namespace emulsion
