#pragma once
// Radiance pictures (.hdr): linear RGB or XYZ, scene-referred, in three significands of 8 bits with one exponent.
// Source: G. Ward, "Radiance File Formats", 1997.

#include <cstdint>
#include <filesystem>

#include "film/scene_picture.h"

namespace emulsion {

/// Components of linear Rec. 709 that the format could not hold.
struct RadianceWriteResult {
    std::int64_t negative_count = 0;  ///< finite, below 0 by more than 2^-20 of the pixel's largest component (colours
                                      ///< outside the gamut of Rec. 709): stored as 0, as those of rounding are
    std::int64_t too_high_count = 0;  ///< finite, above 1.69e38: stored as that
    std::int64_t non_finite_count = 0;  ///< NaN: stored as 0; infinite: as 0 or 1.69e38
    bool operator==(const RadianceWriteResult&) const = default;
};

/// Linear Rec. 709 from XYZ with Y in cd/m^2, with run lengths where they are allowed (8 to 32767 pixels in width).
/// Every component is stored to within 1/255.5 (0.39 %) of the largest of its pixel: dark components of colourful
/// pixels have few digits, or become 0. The file appears whole or not at all. \throws IoError if it can't be written.
/// \throws std::invalid_argument if the picture is empty or the white luminance out of its range.
RadianceWriteResult write_radiance(const std::filesystem::path& path, const Image<XYZ>& xyz,
                                   const SceneWriteOptions& options = {});

/// RGBE or XYZE, stored plainly or with run lengths old or new, in any of the eight orientations, up to 2^20 pixels
/// wide and high. EXPOSURE and COLORCORR are divided out, PRIMARIES honoured. Assumed, and said in the notes: Rec. 709
/// where there are no primaries; 1 cd/m^2 for 1 (Radiance itself has 179 cd/m^2, but few files of others do); RGBE
/// where no FORMAT is given. Bytes behind the picture are left out, and said. \throws IoError naming the line or the
/// byte, what was found and what was expected.
[[nodiscard]] ScenePicture read_radiance(const std::filesystem::path& path);

}  // namespace emulsion
