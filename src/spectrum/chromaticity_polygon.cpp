#include "spectrum/chromaticity_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace emulsion {

namespace {

// Twice the area of the triangle o, a, b: positive if counter-clockwise.
double turn(const Chromaticity& o, const Chromaticity& a, const Chromaticity& b) noexcept {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

double distance_to_segment(const Chromaticity& a, const Chromaticity& b, const Chromaticity& point) noexcept {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double along = ((point.x - a.x) * dx + (point.y - a.y) * dy) / (dx * dx + dy * dy);
    const double t = std::clamp(along, 0.0, 1.0);
    return std::hypot(point.x - a.x - t * dx, point.y - a.y - t * dy);
}

// The lower hull of points sorted by x, or the upper one if they are sorted backwards; without its last point.
template <class Iterator>
void append_chain(Iterator begin, Iterator end, std::vector<Chromaticity>& hull) {
    const std::size_t first = hull.size();
    for (Iterator point = begin; point != end; ++point) {
        while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), *point) <= 0.0) hull.pop_back();
        hull.push_back(*point);
    }
    if (!hull.empty()) hull.pop_back();
}

}  // namespace

std::vector<Chromaticity> convex_hull(std::span<const Chromaticity> points) {
    std::vector<Chromaticity> sorted(points.begin(), points.end());
    const auto before = [](const Chromaticity& a, const Chromaticity& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    };
    std::sort(sorted.begin(), sorted.end(), before);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;

    std::vector<Chromaticity> hull;
    append_chain(sorted.begin(), sorted.end(), hull);
    append_chain(sorted.rbegin(), sorted.rend(), hull);
    return hull;
}

double signed_distance(std::span<const Chromaticity> counter_clockwise, const Chromaticity& point) noexcept {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) return std::numeric_limits<double>::quiet_NaN();
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = true;
    for (std::size_t i = 0; i < counter_clockwise.size(); ++i) {
        const Chromaticity &a = counter_clockwise[i], &b = counter_clockwise[(i + 1) % counter_clockwise.size()];
        nearest = std::min(nearest, distance_to_segment(a, b, point));
        if (turn(a, b, point) < 0.0) inside = false;
    }
    return inside ? nearest : -nearest;
}

}  // namespace emulsion
