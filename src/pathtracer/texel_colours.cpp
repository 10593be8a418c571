#include "pathtracer/texel_colours.h"

namespace emulsion {

TexelColours::TexelColours(ColorSpace space) : sigmoids_(rgb_space_of(space)), is_srgb_(space == ColorSpace::srgb) {
    const Matrix3 matrix = srgb_from(space);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) srgb_from_[i][j] = static_cast<float>(matrix.m[i][j]);
    }
}

SampledSpectrum<3> TexelColours::in_srgb(const RGB& texel) const noexcept {
    SampledSpectrum<3> values;
    values.value = {texel.r, texel.g, texel.b};
    if (is_srgb_) return values;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::array<float, 3>& row = srgb_from_[i];
        values.value[i] = row[0] * texel.r + row[1] * texel.g + row[2] * texel.b;
    }
    return values;
}

}  // namespace emulsion
