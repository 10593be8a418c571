#pragma once
// The channels beside the picture in a film file: their names, and what they may be.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "film/film_picture.h"

namespace emulsion {

/// A FilmPicture that belongs to someone else.
struct PictureView {
    const Image<XYZ>& xyz;
    std::span<const FloatChannel> floats;
    std::span<const CountChannel> counts;
    std::span<const SpectralChannel> spectral;
    PixelBounds data_window;
    int width_px = 0, height_px = 0;
};
[[nodiscard]] PictureView view_of(const FilmPicture& picture);
[[nodiscard]] PictureView view_of(const Image<XYZ>& xyz);  ///< the full frame, without layers

/// \throws std::invalid_argument as write_exr says of its picture.
void validate(const PictureView& picture);

/// Whether a layer is stored as float32 whatever the pixel type: those named "depth" or "variance".
[[nodiscard]] bool is_always_float(std::string_view channel);

/// "S0.550,938nm". Three decimals, and three digits before them: OpenEXR sorts channels by name, which then is by
/// wavelength.
[[nodiscard]] std::string spectral_channel_name(double centre_nm);

/// The wavelength in nm of a channel S0 of the spectral layout, as "S0.550,938nm" or "S0.5,5e2nm"; none for other
/// names, those in other units among them.
[[nodiscard]] std::optional<double> wavelength_of_channel(std::string_view channel);

/// The text of "emulsion.spectralBuckets": by rising wavelength, whatever the order of `spectral`.
[[nodiscard]] std::string buckets_text(std::span<const SpectralChannel> spectral);

/// Gives channels, sorted by the wavelengths of their names, the exact centres and widths of that text. Leaves them as
/// they are if the text is none, or not of these channels.
void apply_buckets_text(std::string_view text, std::vector<SpectralChannel>& spectral);

}  // namespace emulsion
