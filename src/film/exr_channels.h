#pragma once
// The one conversion between XYZ and the channel values of a film file, for writing, reading and as_stored().

#include <array>
#include <optional>
#include <string_view>

#include "core/color.h"
#include "core/matrix3.h"
#include "film/exr_file.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

/// The values of a pixel in a file's three channels: X, Y, Z or R, G, B.
using ChannelValues = std::array<float, 3>;

/// The space of ExrOptions::space as the header's chromaticities state it, in single precision; none for X Y Z.
/// \throws std::invalid_argument for an unknown name, listing those that exist.
[[nodiscard]] std::optional<RgbSpace> space_as_stored(std::string_view name);

/// Rounds to a pixel type.
class ChannelRounder {
  public:
    explicit ChannelRounder(PixelType pixel_type);
    /// Counts in `result` what the type could not hold.
    [[nodiscard]] float round(double value, ExrWriteResult& result) const noexcept;

  private:
    PixelType pixel_type_;
    double largest_;
};

/// From XYZ to channel values.
class ChannelEncoder {
  public:
    /// \throws std::invalid_argument for an unknown space.
    explicit ChannelEncoder(const ExrOptions& options);
    /// Rounded to the pixel type; counts in `result` what it could not hold.
    [[nodiscard]] ChannelValues encode(const XYZ& xyz, ExrWriteResult& result) const noexcept;

  private:
    std::optional<Matrix3> channels_from_xyz_;  // none: the channels are X Y Z
    ChannelRounder rounder_;
};

/// From channel values to XYZ.
class ChannelDecoder {
  public:
    /// `space` of R G B, none for X Y Z; white_luminance_cdm2 of Y = 1 or RGB (1, 1, 1).
    /// \throws std::invalid_argument if the space is degenerate.
    ChannelDecoder(const std::optional<RgbSpace>& space, double white_luminance_cdm2);
    /// Whether decode() changes nothing.
    [[nodiscard]] bool is_identity() const noexcept { return !xyz_from_channels_; }
    [[nodiscard]] XYZ decode(const ChannelValues& channels) const noexcept;

  private:
    std::optional<Matrix3> xyz_from_channels_;  // none: the channels are the values
};

}  // namespace emulsion
