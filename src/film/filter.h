#pragma once
// Reconstruction filters: the weight of a sample in a pixel. All are separable, f(x, y) = f(x) f(y), even, and 0 at and
// past their radius. Offsets and radii are in pixels. Names and defaults are those of pbrt-v4 scene files where it has
// the filter; core/named_value.h prints, parses and lists them. To add one, write its header and put it into Filter.

#include <variant>

#include "core/named_value.h"
#include "film/filter_blackman_harris.h"
#include "film/filter_box.h"
#include "film/filter_gaussian.h"
#include "film/filter_mitchell.h"
#include "film/filter_sinc.h"
#include "film/filter_triangle.h"

namespace emulsion {

using Filter = std::variant<BoxFilter, TriangleFilter, GaussianFilter, MitchellFilter, CatmullRomFilter,
                            LanczosSincFilter, BlackmanHarrisFilter>;

/// The axis that a 1-D weight is asked for: x and y have radii of their own.
enum class FilterAxis { x, y };

/// 1-D weight at `offset_px` = pixel centre - sample position; 0 at and past the radius. Not normalised.
[[nodiscard]] double eval(const Filter& filter, FilterAxis axis, double offset_px) noexcept;
[[nodiscard]] double radius_px(const Filter& filter, FilterAxis axis) noexcept;

/// The least part of the integral of |f| along an axis that the integral of f may be. Below it, samples of a pixel that
/// are weighted to a mean of 1 would have weights of more than 1 / kMinIntegral = 1024 in the mean, of both signs.
inline constexpr double kMinIntegral = 1.0 / 1024.0;

/// Whether f(x, y) is negative anywhere: whether along an axis the integral of f, taken coarsely, is less than that of
/// |f| by more than what rounds off. Lobes that fall between its points hold next to nothing.
[[nodiscard]] bool has_negative_lobes(const Filter& filter) noexcept;

/// \throws std::invalid_argument naming the parameter that is out of range, its value and its range; and if the filter
/// cannot be normalised: its integral along an axis, taken coarsely, is below kMinIntegral, negative or nothing.
void validate(const Filter& filter);

}  // namespace emulsion
