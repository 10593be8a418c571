#include "display/custom_display.h"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "spectrum/chromaticity_polygon.h"

namespace emulsion {

namespace {

std::string text_of(const Chromaticity& c) { return "(" + number_text(c.x) + ", " + number_text(c.y) + ")"; }

}  // namespace

RgbSpace rgb_space(const CustomDisplay& display) {
    return {std::string(CustomDisplay::kName),
            {display.rx, display.ry},
            {display.gx, display.gy},
            {display.bx, display.by},
            {display.wx, display.wy}};
}

void check_triangle(const CustomDisplay& display) {
    const RgbSpace space = rgb_space(display);
    const std::array primaries = {space.red, space.green, space.blue};
    const std::string given =
        "primaries " + text_of(space.red) + ", " + text_of(space.green) + ", " + text_of(space.blue);
    const std::vector<Chromaticity> triangle = convex_hull(primaries);
    if (triangle.size() < 3) throw std::invalid_argument("display custom: " + given + ": must not lie on one line");
    if (signed_distance(triangle, space.white) >= kLeastWhiteDistance) return;
    throw std::invalid_argument("display custom: white " + text_of(space.white) +
                                ": must lie inside the triangle of the " + given + ", " +
                                number_text(kLeastWhiteDistance) + " or more from its sides");
}

}  // namespace emulsion
