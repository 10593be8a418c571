#include "spectrum/sigmoid_table.h"

#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace emulsion {

namespace {

constexpr std::size_t size_of(int resolution) noexcept {
    const auto nodes = static_cast<std::size_t>(resolution);
    return 9 * nodes * nodes * nodes;
}

// The nodes on both sides of a value, and how far the upper one counts.
struct Bracket {
    std::size_t lower;
    float fraction;
};

Bracket bracket(float value, int resolution) noexcept {
    const float position = sigmoid_table_position(value) * static_cast<float>(resolution - 1);
    const int lower = std::min(static_cast<int>(position), resolution - 2);
    return {static_cast<std::size_t>(lower), position - static_cast<float>(lower)};
}

// NaN to 0.
float into_unit_interval(float value) noexcept { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; }

}  // namespace

SigmoidSpectrum sigmoid_of(const SigmoidCoefficients& coefficients) noexcept {
    const auto& k = coefficients.k;
    return {sigmoid_from_centred({k[0], k[1], k[2]})};
}

SigmoidTable::SigmoidTable(const RgbSpace& space) : resolution_(kSigmoidTableResolution) {
    const auto same_colours = [&](std::string_view name) {
        const RgbSpace& other = rgb_space(name);
        return other.red == space.red && other.green == space.green && other.blue == space.blue &&
               other.white == space.white;
    };
    const auto* const found = std::find_if(kSigmoidTableSpaces.begin(), kSigmoidTableSpaces.end(), same_colours);
    if (found == kSigmoidTableSpaces.end()) {
        throw std::invalid_argument(fmt::format("sigmoid table: RGB space {}: expected the primaries and white of {}",
                                                space.name, fmt::join(kSigmoidTableSpaces, ", ")));
    }
    const std::size_t size = size_of(kSigmoidTableResolution);
    const auto table =
        embedded_sigmoid_tables().subspan(static_cast<std::size_t>(found - kSigmoidTableSpaces.begin()) * size, size);
    coefficients_.assign(table.begin(), table.end());
}

SigmoidTable::SigmoidTable(std::vector<float> coefficients, int resolution)
    : coefficients_(std::move(coefficients)), resolution_(resolution) {
    if (resolution < 2 || coefficients_.size() != size_of(resolution)) {
        throw std::invalid_argument(
            fmt::format("sigmoid table: {} coefficients at a resolution of {}: expected 9 resolution^3, of at least 2",
                        coefficients_.size(), resolution));
    }
}

SigmoidCoefficients SigmoidTable::reflectance(const RGB& rgb) const noexcept {
    const std::array<float, 3> c = {into_unit_interval(rgb.r), into_unit_interval(rgb.g), into_unit_interval(rgb.b)};
    if (c[0] == c[1] && c[1] == c[2]) return {{0.0f, 0.0f, inverse_sigmoid(c[0])}};

    // The cell of the table.
    const std::size_t largest = c[0] >= c[1] ? (c[0] >= c[2] ? 0 : 2) : (c[1] >= c[2] ? 1 : 2);
    const float z = c[largest];
    const Bracket along_z = bracket(z, resolution_);
    const Bracket along_x = bracket(c[(largest + 1) % 3] / z, resolution_);
    const Bracket along_y = bracket(c[(largest + 2) % 3] / z, resolution_);

    // Linear along the three axes in turn.
    const auto nodes = static_cast<std::size_t>(resolution_);
    const std::size_t to_next_y = 3 * nodes, to_next_z = 3 * nodes * nodes;
    const float* const corner = coefficients_.data() + largest * 3 * nodes * nodes * nodes + along_z.lower * to_next_z +
                                along_y.lower * to_next_y + along_x.lower * 3;
    const float scale = 1.0f / std::sqrt(z);
    SigmoidCoefficients result;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto on_edge = [&](std::size_t offset) {
            const float start = corner[offset + i], end = corner[offset + 3 + i];
            return start + along_x.fraction * (end - start);
        };
        const auto on_face = [&](std::size_t offset) {
            const float start = on_edge(offset), end = on_edge(offset + to_next_y);
            return start + along_y.fraction * (end - start);
        };
        const float start = on_face(0), end = on_face(to_next_z);
        result.k[i] = scale * (start + along_z.fraction * (end - start));
    }
    return result;
}

ScaledSigmoid SigmoidTable::unbounded(const RGB& rgb) const noexcept {
    const float largest = std::max({0.0f, rgb.r, rgb.g, rgb.b});
    if (!(largest > 0.0f)) return {};
    const float scale = 2.0f * largest;
    return {reflectance({rgb.r / scale, rgb.g / scale, rgb.b / scale}), scale};
}

}  // namespace emulsion
