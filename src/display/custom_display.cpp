#include "display/custom_display.h"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "spectrum/chromaticity_polygon.h"
#include "spectrum/oklab.h"

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

void check_white(const CustomDisplay& display) {
    const XYZd white = xyz_of({display.wx, display.wy});
    for (const double response : kOklabConesFromXyz* std::array{white.x, white.y, white.z}) {
        if (response > 0.0) continue;
        throw std::invalid_argument("display custom: wx = " + number_text(display.wx) +
                                    ", wy = " + number_text(display.wy) +
                                    ": a white that no light has, expected one that all three kinds of cones see");
    }
}

}  // namespace emulsion
