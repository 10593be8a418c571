#include "tonemap/pixel_class.h"

namespace emulsion {

void PixelCounts::add(PixelClass pixel_class) noexcept {
    switch (pixel_class) {
        case PixelClass::positive:
            ++positive;
            break;
        case PixelClass::zero:
            ++zero;
            break;
        case PixelClass::negative:
            ++negative;
            break;
        case PixelClass::nan:
            ++nan;
            break;
        case PixelClass::infinite:
            ++infinite;
            break;
    }
}

PixelCounts& PixelCounts::operator+=(const PixelCounts& other) noexcept {
    positive += other.positive;
    zero += other.zero;
    negative += other.negative;
    nan += other.nan;
    infinite += other.infinite;
    return *this;
}

}  // namespace emulsion
