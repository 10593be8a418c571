#pragma once
// Metamers: reflectances that differ, but look the same under one illuminant to one observer. Under another they drift
// apart.

#include "core/color.h"
#include "spectrum/color_difference.h"
#include "spectrum/observer.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// The light that reflectances are seen in, and who sees them.
struct LightAndObserver {
    Spectrum illuminant;  ///< on any scale
    Observer observer = cie_1931_2deg();
};

/// XYZ of a minus XYZ of b, with Y = 1 for the perfect reflector.
/// \throws std::invalid_argument as xyz_of_reflectance does.
[[nodiscard]] XYZd xyz_difference(const Spectrum& a, const Spectrum& b, const LightAndObserver& conditions);

/// The colour difference of two reflectances, `a` the reference, the perfect reflector being white.
/// \throws std::invalid_argument as xyz_of_reflectance does.
[[nodiscard]] double lab_difference(const Spectrum& a, const Spectrum& b, const LightAndObserver& conditions,
                                    const ColorDifference& method);

/// Largest difference of X, Y or Z that still counts as none.
struct XyzTolerance {
    double largest = 1e-9;  ///< >= 0, of Y = 1 for the perfect reflector
};

/// Largest colour difference that still counts as none.
struct LabTolerance {
    ColorDifference method = Cie76Difference{};
    double largest = 1e-6;  ///< >= 0
};

/// Whether two reflectances look the same. So do two that are the same, which a strict reader wouldn't call metamers.
/// \throws std::invalid_argument if the tolerance is negative or NaN, and as xyz_of_reflectance does.
[[nodiscard]] bool are_metameric(const Spectrum& a, const Spectrum& b, const LightAndObserver& conditions,
                                 const XyzTolerance& tolerance);
[[nodiscard]] bool are_metameric(const Spectrum& a, const Spectrum& b, const LightAndObserver& conditions,
                                 const LabTolerance& tolerance);

struct MetamerismIndex {
    double index = 0.0;                 ///< colour difference under the test conditions, corrected
    double reference_difference = 0.0;  ///< colour difference under the reference conditions: 0 for exact metamers
};

/// The special metamerism index: how different two reflectances look under test conditions, if they look the same under
/// the reference conditions. Where they don't quite, X, Y and Z of `b` under the test conditions are multiplied by
/// those of `a` over those of `b` under the reference conditions; that is sound for small differences only, so the
/// caller should look at reference_difference. Change in illuminant or in observer, as the conditions differ in.
/// Source: CIE 15:2004, section 9.2 (change in illuminant), which takes CIELAB's difference unless another is named,
/// and suggests D65 as reference and A as test illuminant. The multiplicative correction: Brockes, Die Farbe 19 (1970).
/// \throws std::invalid_argument as xyz_of_reflectance does, and if X, Y or Z of `b` under the reference conditions is
/// 0 and that of `a` isn't.
[[nodiscard]] MetamerismIndex metamerism_index(const Spectrum& a, const Spectrum& b, const LightAndObserver& reference,
                                               const LightAndObserver& test, const ColorDifference& method);

}  // namespace emulsion
