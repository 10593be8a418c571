#pragma once
// Loss of acuity: in the dark, fine detail cannot be seen. Luminances in cd/m^2, frequencies in cycles a degree.

#include "core/color.h"
#include "core/image.h"

namespace emulsion {

/// 17.25 atan(1.4 log10 La + 0.35) + 25.72: the highest frequency that can be seen, a fit to the data of Shlaer 1937;
/// La below 1e-5 counts as 1e-5, where it is 1.2, since the fit falls below 0 in the end. Source: Ward Larson,
/// Rushmeier & Piatko 1997 (rod_vision.h), eq. 15.
[[nodiscard]] double highest_visible_frequency(double adaptation_cdm2) noexcept;

/// Standard deviation of a blur, in degrees, under which a grating of that frequency keeps 5 % of its contrast, without
/// what an eye adapted to kMostMesopic_cdm2 loses anyway: whoever looks at the picture has such an eye. 0 from that
/// luminance on, so that a bright picture stays as it is.
[[nodiscard]] double acuity_blur_degrees(double adaptation_cdm2) noexcept;

struct AcuityLoss {
    double weight = 1.0;          ///< of the blur's width, in [0, 1]
    double degrees_per_px = 0.0;  ///< > 0
};

/// Blurs every good pixel (pixel_class.h) as far as the eye, adapted to the degree about it, sees less: the Gaussian
/// mean of Y with standard deviation 0.25 degrees, that of a disc as wide as the fovea. In place, by interpolation
/// between levels of a pyramid, as the source does. Every result is a mean of good pixels, the picture mirrored at its
/// edges: a constant stays as it is; light is not conserved, as eyes don't. Interpolated levels are no Gaussians: of
/// squares of noise six pixels wide, within 5 % of their luminance of the twin on average, and 20 % anywhere. As
/// colours on a display (tests/develop/vision_differences_test.cpp: parts of three pictures at 0.001 and 0.1 cd/m^2,
/// fields of 5 and 20 degrees), CIEDE2000 is at most 0.7 on average and 6 anywhere; measured 0.53 and 5.3. Memory: one
/// picture. The same bits for every number of threads (0: all). \throws std::invalid_argument if threads < 0.
void lose_acuity(ImageView<XYZ> picture, const AcuityLoss& loss, int threads);

/// The double-precision twin: a Gaussian mean for each pixel. `scene` tells which pixels are bad.
[[nodiscard]] Image<XYZd> lose_acuity_reference(const Image<XYZd>& picture, ImageView<const XYZ> scene,
                                                const AcuityLoss& loss);

}  // namespace emulsion
