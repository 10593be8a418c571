#pragma once
// A picture of known luminances for `emulsion develop`.

#include <string>

#include "film/exr_file.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {

/// Luminances 1 to 64 cd/m^2 from left to right.
inline FilmPicture ramp() {
    FilmPicture picture;
    picture.xyz = Image<XYZ>(64, 16);
    picture.data_window = {0, 0, 64, 16};
    picture.width_px = 64;
    picture.height_px = 16;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 64; ++x)
            picture.xyz(x, y) = {1.0f + static_cast<float>(x), 1.0f + static_cast<float>(x), 9.0f};
    }
    return picture;
}

inline std::string write_picture(const TemporaryFolder& folder, const FilmPicture& picture) {
    const std::string exr = folder.file("ramp.exr");
    (void)write_exr(exr, picture, {}, {});
    return exr;
}

inline std::string write_ramp(const TemporaryFolder& folder) { return write_picture(folder, ramp()); }

}  // namespace emulsion::testing
