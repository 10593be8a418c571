#pragma once
// What an operator promises beyond its formula. The property tests hold every operator to what it says here.

namespace emulsion {

/// What happens to a picture that is given in another unit of luminance.
enum class UnitOfLuminance {
    cancels,         ///< the same picture comes out
    nearly_cancels,  ///< the same if the units differ by a power of 2, or else within 4/255 on most pictures, 6/255 on
                     ///< small ones with edges: what is taken from the picture's range, with some parameters only, is
                     ///< taken from LuminanceHistogram, and the ends of the range may move by half a bin, 1.6 %
    absolute,        ///< the operator is about luminances in cd/m^2: another picture comes out
};

/// What a pixel of 1e30 cd/m^2 does to the other pixels, of a thousand or more: where there are fewer, the one that it
/// stands for has a weight of its own in the log-average, and in a range that has no outliers to leave out.
enum class OutlierEffect {
    none,         ///< they move by at most 2/255; around it under a local adaptation see docs/tone-mapping.md
    darkens_all,  ///< they become black: that is the method
};

/// Whether of two pixels the brighter one comes out at least as bright.
enum class Monotone {
    everywhere,  ///< yes, in a picture under one adaptation
    locally,     ///< only where adaptation is the same: neighbourhoods differ
};

struct OperatorTraits {
    UnitOfLuminance unit = UnitOfLuminance::cancels;
    OutlierEffect outliers = OutlierEffect::none;
    Monotone monotone = Monotone::everywhere;
};

}  // namespace emulsion
