#pragma once
// Plane polar coordinates: of the two chromatic components of a colour, chroma and hue.

namespace emulsion {

/// Hue is in degrees, in [0, 360), anticlockwise from the first component; 0 for chroma 0. For a grey that came out
/// with a chroma of rounding size, the hue is any. NaN stays NaN.
struct ChromaHue {
    double chroma = 0.0;  ///< >= 0
    double hue_deg = 0.0;
    bool operator==(const ChromaHue&) const = default;
};

/// The two chromatic components: (a*, b*), (u*, v*).
struct Chromatic {
    double first = 0.0, second = 0.0;
    bool operator==(const Chromatic&) const = default;
};

[[nodiscard]] ChromaHue chroma_hue_of(const Chromatic& chromatic) noexcept;
/// Any hue, also outside [0, 360); a negative chroma is that of the opposite hue.
[[nodiscard]] Chromatic chromatic_of(const ChromaHue& polar) noexcept;

}  // namespace emulsion
