#pragma once
// Veiling glare: light scattered in the eye lies as a veil over the picture. Angles from the line of sight.

#include "core/color.h"
#include "core/image.h"

namespace emulsion {

/// Part of the adaptation that is due to scattered light: 0.087, 0.913 being the fovea's. Source: Moon & Spencer, "The
/// Visual Effect of Non-Uniform Surrounds", J. Opt. Soc. Am. 35(3), 1945, after Holladay, as Ward Larson, Rushmeier &
/// Piatko 1997 (rod_vision.h) have it in eq. 8 to 11.
inline constexpr double kVeilShare = 0.087;

/// Light scattered by theta, in steradian^-1, relative: 1 / theta^2, as of the same source. Departs from it within the
/// fovea, which that samples by pixels of a degree and leaves out: 1 / (theta^2 + f^2), f = 0.5 degrees, its radius.
/// Of a plane at distance 1, d from where the line of sight meets it: cos^4(theta) / (theta^2 + f^2), theta = atan(d),
/// for the cosine of the source's and the solid angle of the plane's parts.
[[nodiscard]] double veil_kernel(double tangent) noexcept;

/// (1 - share) picture + share (picture convolved with veil_kernel); edges and bad pixels as in spread_light.h: the
/// scene goes on beside the picture as its mirror images. The same kernel for all pixels, as if each were the centre.
/// Within 3 % of the twin as to where scattered light falls.
/// \param tangent_per_px of the angle between neighbouring pixels at the centre
/// \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<XYZ> add_veil(ImageView<const XYZ> scene, double share, double tangent_per_px, int threads);

/// The double-precision twin: direct convolution, up to tangent 20.
[[nodiscard]] Image<XYZd> add_veil_reference(ImageView<const XYZ> scene, double share, double tangent_per_px);

}  // namespace emulsion
