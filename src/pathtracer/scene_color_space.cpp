#include "pathtracer/scene_color_space.h"

#include <array>
#include <cmath>
#include <string_view>

#include "spectrum/chromaticity.h"

namespace emulsion {

namespace {

bool is_close(double given, double known) noexcept {
    constexpr double kTolerance = 1e-3;
    // A coordinate of 0, as that of the green of ACES, has to be met exactly.
    return given == known || std::abs((given - known) / known) < kTolerance;
}
bool is_close(const Chromaticity& given, const Chromaticity& known) noexcept {
    return is_close(given.x, known.x) && is_close(given.y, known.y);
}

}  // namespace

const RgbSpace& rgb_space_of(ColorSpace space) {
    constexpr std::array<std::string_view, kColorSpaces> kNames = {"sRGB", "Rec2020", "Display_P3", "ACES2065_1_AP0"};
    return rgb_space(kNames.at(static_cast<std::size_t>(space)));
}

std::optional<ColorSpace> color_space_with_primaries_of(const RgbSpace& space) {
    for (const ColorSpace known : {ColorSpace::srgb, ColorSpace::rec2020, ColorSpace::dci_p3, ColorSpace::aces2065_1}) {
        const RgbSpace& other = rgb_space_of(known);
        const bool same = is_close(space.red, other.red) && is_close(space.green, other.green) &&
                          is_close(space.blue, other.blue) && is_close(space.white, other.white);
        if (same) return known;
    }
    return std::nullopt;
}

}  // namespace emulsion
