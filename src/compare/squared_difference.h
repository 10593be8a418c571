#pragma once
// How far two pictures are apart in light, and how much of that is their noise. Numbers are relative to a white, whose
// X, Y and Z are 1 each: of scene-referred light there is no other unit in which a constant makes sense.

#include <cstdint>
#include <optional>

#include "compare/compared_picture.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion {

/// In the denominator of the relative mean squared error: a tenth of white, squared.
inline constexpr double kRelativeErrorOffset = 0.01;

/// A relative mean squared difference D of A and B, over pixels and components, is what noise adds to it and the rest:
///     D = mean w (b - a)^2,   noise N = mean w (sa^2 + sb^2),   bias = D - N,   w = 1 / (m^2 + 0.01),
/// with the pixels' standard errors sa and sb, and m, the mean of A and B over the up to eight pixels around this one.
/// Weights keep a few bright pixels, such as those of the edges of a lamp, from being all that counts; and as a pixel's
/// own noise has no part in its weight (as a^2 in the relative error has), they do not depend on it. So, if A and B are
/// noisy independently of each other, N is the expected D of two pictures of the same expectation, and D - N an
/// unbiased estimate of what the squared difference of the expectations comes to. It may be below 0, by a few of its
/// standard errors, which are those of a mean over independent pixels. (Where a filter splats samples, pixels are not
/// quite independent.) A's noise counts like that of B.
struct NoiseAndBias {
    KnownNoise components = KnownNoise::xyz;  ///< over which of them: X, Y and Z, or Y alone
    std::int64_t pixels = 0;                  ///< of which the noise of both is known; >= 1
    double mean_squared = 0.0;                ///< D
    double noise = 0.0;                       ///< N
    double bias = 0.0;                        ///< D - N
    double bias_standard_error = 0.0;
    bool operator==(const NoiseAndBias&) const = default;

    /// Shares of D; 0 if there is no difference.
    [[nodiscard]] double noise_share() const noexcept { return share(noise); }
    [[nodiscard]] double bias_share() const noexcept { return share(bias); }
    [[nodiscard]] double bias_share_standard_error() const noexcept { return share(bias_standard_error); }

  private:
    [[nodiscard]] double share(double part) const noexcept { return mean_squared > 0.0 ? part / mean_squared : 0.0; }
};

struct SquaredDifference {
    std::int64_t pixels = 0;    ///< all but those that are not finite in A or in B
    double mean_squared = 0.0;  ///< over X, Y and Z, in squares of white
    /// Mean of (b - a)^2 / (a^2 + 0.01) over linear R, G and B of Rec. 709, 1 for white. Source: F. Rousselle,
    /// C. Knaus, M. Zwicker, "Adaptive sampling and reconstruction using greedy error minimization", SIGGRAPH Asia
    /// 2011, and the "relative squared error" of tev. pbrt-v4's MRSE has (a + 0.01)^2 below. The constant is a square
    /// of whatever the file is in there, of white here, so that the unit of luminance makes no difference.
    double relative = 0.0;
    std::optional<NoiseAndBias> parts = std::nullopt;  ///< none if the noise of either is unknown in all pixels
    bool operator==(const SquaredDifference&) const = default;
};

/// Of pictures of one size. Pixels as they are: nothing is clipped. Sums in double precision, the same bits for every
/// number of threads (0: all). \throws std::invalid_argument if threads < 0.
[[nodiscard]] SquaredDifference squared_difference(const ComparedPicture& a, const ComparedPicture& b,
                                                   const ViewingConditions& viewing, int threads);

}  // namespace emulsion
