#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "core/error.h"
#include "film/radiance_file.h"
#include "film/radiance_limits.h"
#include "film/rgbe.h"
#include "film/scene_rgb.h"

namespace emulsion {

namespace {

/// Below 0 by no more than this of the pixel's largest component is rounding in the matrix from XYZ, not a colour.
constexpr float kRounding = 0x1p-20f;

/// What can be stored instead; counts what can't be itself.
float storable(float value, float largest, RadianceWriteResult& result) noexcept {
    constexpr float kLargest = 255.0f / 256.0f * 0x1p127f;
    if (!std::isfinite(value)) {
        ++result.non_finite_count;
        return value > 0.0f ? kLargest : 0.0f;
    }
    if (value < 0.0f && !(-value <= kRounding * largest)) ++result.negative_count;
    if (value > kLargest) ++result.too_high_count;
    return std::clamp(value, 0.0f, kLargest);
}

/// How many pixels from `from` on have the same component, up to 127.
std::size_t run_at(std::span<const Rgbe> row, std::size_t component, std::size_t from) noexcept {
    std::size_t length = 1;
    while (length < 127 && from + length < row.size() && row[from + length][component] == row[from][component]) {
        ++length;
    }
    return length;
}

/// One component of a row: runs of at least four (count + 128, value), and others (count, values).
void put_component(std::span<const Rgbe> row, std::size_t component, std::string& bytes) {
    constexpr std::size_t kShortestRun = 4, kMostOthers = 128;
    for (std::size_t at = 0; at < row.size();) {
        const std::size_t run = run_at(row, component, at);
        if (run >= kShortestRun) {
            bytes += static_cast<char>(128 + run);
            bytes += static_cast<char>(row[at][component]);
            at += run;
            continue;
        }
        std::size_t end = at + run;
        while (end < row.size() && end - at < kMostOthers && run_at(row, component, end) < kShortestRun) ++end;
        bytes += static_cast<char>(end - at);
        for (; at < end; ++at) bytes += static_cast<char>(row[at][component]);
    }
}

void put_row(std::span<const Rgbe> row, std::string& bytes) {
    if (row.size() < kLeastRunWidth || row.size() > kMostRunWidth) {
        for (const Rgbe& pixel : row) {
            for (const std::uint8_t byte : pixel) bytes += static_cast<char>(byte);
        }
        return;
    }
    bytes += "\2\2";
    bytes += static_cast<char>(row.size() >> 8u);
    bytes += static_cast<char>(row.size() & 0xffu);
    for (std::size_t component = 0; component < 4; ++component) put_component(row, component, bytes);
}

}  // namespace

RadianceWriteResult write_radiance(const std::filesystem::path& path, const Image<XYZ>& xyz,
                                   const SceneWriteOptions& options) {
    const SceneRgb to_rgb(xyz, options);
    AtomicFile file(path);
    std::ofstream stream(file.temporary_path(), std::ios::binary | std::ios::trunc);
    stream << "#?RADIANCE\nSOFTWARE=Emulsion\nPRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329\n"
              "FORMAT=32-bit_rle_rgbe\n\n-Y "
           << xyz.height() << " +X " << xyz.width() << '\n';
    RadianceWriteResult result;
    std::vector<Rgbe> row(static_cast<std::size_t>(xyz.width()));
    std::string bytes;
    for (int y = 0; y < xyz.height(); ++y) {
        bytes.clear();
        std::transform(xyz.row(y).begin(), xyz.row(y).end(), row.begin(), [&](const XYZ& pixel) {
            const RGB rgb = to_rgb(pixel);
            const float largest = std::max({rgb.r, rgb.g, rgb.b});
            return to_rgbe(
                {storable(rgb.r, largest, result), storable(rgb.g, largest, result), storable(rgb.b, largest, result)});
        });
        put_row(row, bytes);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    stream.close();
    if (!stream) throw IoError(path, "cannot write: " + errno_text(errno));
    file.commit();
    return result;
}

}  // namespace emulsion
