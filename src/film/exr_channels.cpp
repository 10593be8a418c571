#include "film/exr_channels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <Imath/half.h>

#include "core/name_key.h"
#include "core/named_value.h"
#include "spectrum/data_table.h"

namespace emulsion {

namespace {

double as_float(double value) { return static_cast<double>(static_cast<float>(value)); }
Chromaticity as_float(const Chromaticity& point) { return {as_float(point.x), as_float(point.y)}; }

}  // namespace

std::vector<std::string> exr_space_names() {
    std::vector<std::string> names = data_table("rgb_colourspaces").row_names;
    names.insert(names.begin(), kXyzSpaceName);
    return names;
}

std::optional<RgbSpace> space_as_stored(std::string_view name) {
    const std::string wanted = name_key(name);
    const std::vector<std::string> names = exr_space_names();
    const auto found = std::find_if(names.begin(), names.end(), [&](const auto& n) { return name_key(n) == wanted; });
    if (found == names.end()) throw_unknown_name("EXR space", name, {names.begin(), names.end()});
    if (found == names.begin()) return std::nullopt;
    const RgbSpace& exact = rgb_space(*found);
    return RgbSpace{exact.name, as_float(exact.red), as_float(exact.green), as_float(exact.blue),
                    as_float(exact.white)};
}

ExrWriteResult& ExrWriteResult::operator+=(const ExrWriteResult& other) noexcept {
    too_high_count += other.too_high_count;
    too_low_count += other.too_low_count;
    vanished_positive_count += other.vanished_positive_count;
    vanished_negative_count += other.vanished_negative_count;
    non_finite_count += other.non_finite_count;
    return *this;
}

ChannelRounder::ChannelRounder(PixelType pixel_type)
    : pixel_type_(pixel_type),
      largest_(pixel_type == PixelType::half ? 65504.0 : static_cast<double>(std::numeric_limits<float>::max())) {}

float ChannelRounder::round(double value, ExrWriteResult& result) const noexcept {
    const double given = value;
    if (!std::isfinite(value)) {
        ++result.non_finite_count;
    } else if (std::abs(value) > largest_) {
        ++(value > 0.0 ? result.too_high_count : result.too_low_count);
        value = std::copysign(largest_, value);
    }
    auto rounded = static_cast<float>(value);
    if (pixel_type_ == PixelType::half) rounded = static_cast<float>(half(rounded));
    if (rounded == 0.0f && given != 0.0) {
        ++(given > 0.0 ? result.vanished_positive_count : result.vanished_negative_count);
    }
    return rounded;
}

ChannelEncoder::ChannelEncoder(const ExrOptions& options) : rounder_(options.pixel_type) {
    if (const auto space = space_as_stored(options.space)) channels_from_xyz_ = rgb_from_xyz(*space);
}

ChannelValues ChannelEncoder::encode(const XYZ& xyz, ExrWriteResult& result) const noexcept {
    std::array<double, 3> values = {static_cast<double>(xyz.x), static_cast<double>(xyz.y), static_cast<double>(xyz.z)};
    if (channels_from_xyz_) values = *channels_from_xyz_ * values;
    return {rounder_.round(values[0], result), rounder_.round(values[1], result), rounder_.round(values[2], result)};
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
