#include "film/exr_channels.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include <Imath/half.h>

namespace emulsion {

namespace {

double as_float(double value) { return static_cast<double>(static_cast<float>(value)); }
Chromaticity as_float(const Chromaticity& point) { return {as_float(point.x), as_float(point.y)}; }

}  // namespace

RgbSpace rec709_as_stored() {
    const RgbSpace& exact = rgb_space("sRGB");
    return {exact.name, as_float(exact.red), as_float(exact.green), as_float(exact.blue), as_float(exact.white)};
}

ChannelEncoder::ChannelEncoder(const ExrOptions& options)
    : pixel_type_(options.pixel_type),
      largest_(options.pixel_type == PixelType::half ? 65504.0
                                                     : static_cast<double>(std::numeric_limits<float>::max())) {
    if (options.color == ExrColor::rec709) channels_from_xyz_ = rgb_from_xyz(rec709_as_stored());
}

float ChannelEncoder::round(double value, ExrWriteResult& result) const noexcept {
    if (!std::isfinite(value)) {
        ++result.non_finite_count;
    } else if (std::abs(value) > largest_) {
        ++result.clamped_count;
        value = std::copysign(largest_, value);
    }
    const auto single = static_cast<float>(value);
    return pixel_type_ == PixelType::half ? static_cast<float>(half(single)) : single;
}

ChannelValues ChannelEncoder::encode(const XYZ& xyz, ExrWriteResult& result) const noexcept {
    std::array<double, 3> values = {static_cast<double>(xyz.x), static_cast<double>(xyz.y), static_cast<double>(xyz.z)};
    if (channels_from_xyz_) values = *channels_from_xyz_ * values;
    return {round(values[0], result), round(values[1], result), round(values[2], result)};
}

ChannelDecoder::ChannelDecoder(const std::optional<RgbSpace>& space, double white_luminance_cdm2) {
    if (!space && white_luminance_cdm2 == 1.0) return;
    Matrix3 matrix{{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}}};
    if (space) matrix = xyz_from_rgb(*space);
    for (auto& row : matrix.m) {
        for (double& entry : row) entry *= white_luminance_cdm2;
    }
    xyz_from_channels_ = matrix;
}

XYZ ChannelDecoder::decode(const ChannelValues& channels) const noexcept {
    if (!xyz_from_channels_) return {channels[0], channels[1], channels[2]};
    const auto value = [&](std::size_t i) { return static_cast<double>(channels[i]); };
    const std::array<double, 3> xyz = *xyz_from_channels_ * std::array<double, 3>{value(0), value(1), value(2)};
    return {static_cast<float>(xyz[0]), static_cast<float>(xyz[1]), static_cast<float>(xyz[2])};
}

}  // namespace emulsion
