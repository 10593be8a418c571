#include "spectrum/metamerism.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/core.h>

#include "spectrum/cielab.h"
#include "spectrum/colorimetry.h"

namespace emulsion {

namespace {

// Two reflectances and the perfect reflector, seen alike.
struct Pair {
    XYZd a, b, white;
};

Pair seen(const Spectrum& a, const Spectrum& b, const LightAndObserver& conditions) {
    const auto xyz = [&](const Spectrum& reflectance) {
        return xyz_of_reflectance(reflectance, conditions.illuminant, conditions.observer);
    };
    return {xyz(a), xyz(b), xyz(ConstantSpectrum{1.0})};
}

double difference_of(const Pair& pair, const ColorDifference& method) {
    return difference(method, lab_from_xyz(pair.a, pair.white), lab_from_xyz(pair.b, pair.white));
}

void require_tolerance(double largest) {
    if (largest >= 0.0) return;
    throw std::invalid_argument(fmt::format("tolerance: largest = {}: expected a number >= 0", largest));
}

double correction(char component, double a, double b) {
    if (a == b) return 1.0;
    if (b != 0.0) return a / b;
    throw std::invalid_argument(fmt::format(
        "metamerism index: {} = 0 of b under the reference conditions: expected another value, as that of a is {}",
        component, a));
}

}  // namespace

XYZd xyz_difference(const Spectrum& a, const Spectrum& b, const LightAndObserver& conditions) {
    const Pair pair = seen(a, b, conditions);
    return pair.a + -1.0 * pair.b;
}

double lab_difference(const Spectrum& a, const Spectrum& b, const LightAndObserver& conditions,
                      const ColorDifference& method) {
    return difference_of(seen(a, b, conditions), method);
}

bool are_metameric(const Spectrum& a, const Spectrum& b, const LightAndObserver& conditions,
                   const XyzTolerance& tolerance) {
    require_tolerance(tolerance.largest);
    const XYZd xyz = xyz_difference(a, b, conditions);
    return std::max({std::abs(xyz.x), std::abs(xyz.y), std::abs(xyz.z)}) <= tolerance.largest;
}

bool are_metameric(const Spectrum& a, const Spectrum& b, const LightAndObserver& conditions,
                   const LabTolerance& tolerance) {
    require_tolerance(tolerance.largest);
    return lab_difference(a, b, conditions, tolerance.method) <= tolerance.largest;
}

MetamerismIndex metamerism_index(const Spectrum& a, const Spectrum& b, const LightAndObserver& reference,
                                 const LightAndObserver& test, const ColorDifference& method) {
    const Pair at_reference = seen(a, b, reference);
    Pair at_test = seen(a, b, test);
    at_test.b.x *= correction('X', at_reference.a.x, at_reference.b.x);
    at_test.b.y *= correction('Y', at_reference.a.y, at_reference.b.y);
    at_test.b.z *= correction('Z', at_reference.a.z, at_reference.b.z);
    return {difference_of(at_test, method), difference_of(at_reference, method)};
}

}  // namespace emulsion
