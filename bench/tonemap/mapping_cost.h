#pragma once
// What tone mapping a picture of some size costs: time, processor time and memory.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/row_blocks.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {

/// Six decades: waves, edges of one decade every few hundred pixels, and noise, whatever the size. One multiplication
/// a pixel.
inline void fill_with_scene(Image<XYZ>& picture) {
    std::vector<float> across(static_cast<std::size_t>(picture.width()));
    for (std::size_t x = 0; x < across.size(); ++x) {
        const auto step = static_cast<float>(x / 307 % 3) - 1.0f;
        across[x] = std::pow(10.0f, step + std::sin(0.013f * static_cast<float>(x)));
    }
    parallel_for_rows(picture.width(), picture.height(), 0, [&](int y) {
        const auto step = 0.5f * static_cast<float>(y / 211 % 3) - 0.5f;
        const float down = std::pow(10.0f, step + 0.5f * std::cos(0.007f * static_cast<float>(y)));
        std::uint32_t noise = 2654435761u * static_cast<std::uint32_t>(y + 1);
        for (std::size_t x = 0; x < across.size(); ++x) {
            noise = 1664525u * noise + 1013904223u;
            const float luminance = across[x] * down * (1.0f + 0x1p-26f * static_cast<float>(noise >> 8));
            picture.row(y)[x] = {0.9f * luminance, luminance, 1.2f * luminance};
        }
    });
}

/// Every component finite, Y >= 0, and a tenth of the pixels not black.
inline bool is_sound(const Image<XYZ>& display) {
    const auto pixels = display.pixels();
    const auto is_defined = [](const XYZ& p) { return std::isfinite(p.x + p.y + p.z) && p.y >= 0.0f; };
    const auto lit = std::count_if(pixels.begin(), pixels.end(), [](const XYZ& p) { return p.y > 1.0f / 255.0f; });
    return std::all_of(pixels.begin(), pixels.end(), is_defined) && 10 * static_cast<std::size_t>(lit) > pixels.size();
}

struct MappingCost {
    double seconds = 0.0;
    double cpu_seconds = 0.0;  ///< of all threads, the system's share too
    double peak_bytes = 0.0;   ///< most memory that the process had at once, the picture included
};

/// Maps a square picture in place on all threads, in this process, `repeats` times; one cost each.
/// \throws std::runtime_error if what comes out is not sound.
inline std::vector<MappingCost> mapping_costs(const ToneMapper& mapper, int size_px, int repeats) {
    constexpr XYZ kWhite{0.95f, 1.0f, 1.09f};
    Image<XYZ> picture(size_px, size_px);
    std::vector<MappingCost> costs;
    for (int i = 0; i < repeats; ++i) {
        MappingCost& cost = costs.emplace_back();
        fill_with_scene(picture);
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t cpu_start = std::clock();
        tone_map_into({mapper}, picture.view(), picture.view(), kWhite, 0);
        cost.cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
        cost.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        cost.peak_bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
        if (!is_sound(picture)) throw std::runtime_error(to_text(mapper) + ": what came out is not sound");
    }
    return costs;
}

/// The same in a process of its own, so that the peak is that of this mapping. \throws std::runtime_error if it fails.
inline std::vector<MappingCost> mapping_costs_apart(const ToneMapper& mapper, int size_px, int repeats) {
    int ends[2] = {};
    if (pipe(ends) != 0) throw std::runtime_error("pipe");
    std::vector<MappingCost> costs(static_cast<std::size_t>(repeats));
    const auto bytes = static_cast<ssize_t>(costs.size() * sizeof(MappingCost));
    const pid_t child = fork();
    if (child == 0) {
        try {
            costs = mapping_costs(mapper, size_px, repeats);
            _exit(write(ends[1], costs.data(), static_cast<std::size_t>(bytes)) == bytes ? 0 : 1);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
            _exit(1);
        }
    }
    close(ends[1]);
    const bool is_read = read(ends[0], costs.data(), static_cast<std::size_t>(bytes)) == bytes;
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!is_read || status != 0) throw std::runtime_error("mapping " + to_text(mapper) + " failed");
    return costs;
}

/// Pixels on a side of a square of about so many megapixels (10^6 pixels).
inline int side_of_megapixels(double megapixels) { return static_cast<int>(std::lround(std::sqrt(1e6 * megapixels))); }

}  // namespace emulsion
