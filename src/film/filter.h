#pragma once
// Reconstruction filters: the weight of a sample in a pixel. All are separable, f(x, y) = f(x) f(y), even, and 0 at and
// past their radius. Offsets and radii are in pixels. Names, parameters and defaults are those of pbrt-v4 scene files.

#include <string_view>
#include <variant>

namespace emulsion {

struct BoxFilter {
    static constexpr std::string_view kName = "box";
    float x_radius_px = 0.5f;  ///< half-width of the support; finite, > 0
    float y_radius_px = 0.5f;  ///< half-height of the support; finite, > 0
    bool operator==(const BoxFilter&) const = default;
};

/// The tent 1 - |x|/radius.
struct TriangleFilter {
    static constexpr std::string_view kName = "triangle";
    float x_radius_px = 2.0f;  ///< finite, > 0
    float y_radius_px = 2.0f;  ///< finite, > 0
    bool operator==(const TriangleFilter&) const = default;
};

/// A Gaussian less its value at the radius, so that it ends at 0.
struct GaussianFilter {
    static constexpr std::string_view kName = "gaussian";
    float x_radius_px = 1.5f;  ///< finite, > 0
    float y_radius_px = 1.5f;  ///< finite, > 0
    float sigma_px = 0.5f;     ///< standard deviation before the cut; finite, > 0
    bool operator==(const GaussianFilter&) const = default;
};

/// Separable cubic k(2x/radius), with negative lobes.
/// Source: Mitchell & Netravali, "Reconstruction Filters in Computer Graphics", SIGGRAPH 1988, eq. 8.
struct MitchellFilter {
    static constexpr std::string_view kName = "mitchell";
    float x_radius_px = 2.0f;  ///< finite, > 0
    float y_radius_px = 2.0f;  ///< finite, > 0
    float b = 1.0f / 3.0f;     ///< blur; finite
    float c = 1.0f / 3.0f;     ///< ringing; finite
    bool operator==(const MitchellFilter&) const = default;
};

/// sinc(x) sinc(x / tau): a sinc under a Lanczos window. sinc(x) = sin(pi x)/(pi x), zeros at whole pixels.
/// Source: Duchon, "Lanczos Filtering in One and Two Dimensions", J. Appl. Meteor. 18 (1979).
struct LanczosSincFilter {
    static constexpr std::string_view kName = "sinc";
    float x_radius_px = 4.0f;  ///< finite, > 0
    float y_radius_px = 4.0f;  ///< finite, > 0
    float tau = 3.0f;          ///< where the window first reaches 0, in pixels; finite, > 0
    bool operator==(const LanczosSincFilter&) const = default;
};

using Filter = std::variant<BoxFilter, TriangleFilter, GaussianFilter, MitchellFilter, LanczosSincFilter>;

/// The axis that a 1-D weight is asked for: x and y have radii of their own.
enum class FilterAxis { x, y };

/// 1-D weight at `offset_px` = pixel centre - sample position; 0 at and past the radius. Not normalised.
[[nodiscard]] double eval(const Filter& filter, FilterAxis axis, double offset_px) noexcept;
[[nodiscard]] double radius_px(const Filter& filter, FilterAxis axis) noexcept;

/// \throws std::invalid_argument naming the parameter that is out of range, its value and its range.
void validate(const Filter& filter);

}  // namespace emulsion
