#pragma once
// What a film gives out: its picture and, if asked for, layers beside it. Scene-referred throughout.

#include <cstdint>
#include <string>
#include <vector>

#include "core/color.h"
#include "core/image.h"

namespace emulsion {

/// A layer of numbers, by its full name in a file: "variance.Y", "albedo.R", "depth.Z".
struct FloatChannel {
    std::string name;  ///< of 1 to 255 characters
    Image<float> values;
    bool operator==(const FloatChannel&) const = default;
};

/// A layer of whole numbers: "samples".
struct CountChannel {
    std::string name;  ///< of 1 to 255 characters
    Image<std::uint32_t> values;
    bool operator==(const CountChannel&) const = default;
};

/// Radiance in one bucket of wavelengths, its mean over [centre - width / 2, centre + width / 2].
struct SpectralChannel {
    double centre_nm = 0.0;  ///< in [100, 1000)
    double width_nm = 0.0;   ///< >= 0; 0: unknown
    Image<float> values;     ///< W m^-2 sr^-1 nm^-1
    bool operator==(const SpectralChannel&) const = default;
};

/// All images have the size of xyz.
struct FilmPicture {
    Image<XYZ> xyz;  ///< Y in cd/m^2 (times the imaging ratio, where the film is exposed)
    std::vector<FloatChannel> floats = {};
    std::vector<CountChannel> counts = {};
    std::vector<SpectralChannel> spectral = {};
    PixelBounds data_window = {};     ///< where xyz lies in the full frame; may reach beyond it
    int width_px = 0, height_px = 0;  ///< of the full frame, whose first pixel is (0, 0); both >= 1
    bool operator==(const FilmPicture&) const = default;
};

}  // namespace emulsion
