#pragma once
// How hard a PNG is compressed. Dithering is noise, in which zlib finds hardly a string twice: most of its time goes
// into looking. Run lengths and Huffman codes of what the Paeth filter leaves are as short on pictures.
//
// Size over that of libpng's own default (level 6), and how many times as fast in CPU time, one thread; error-diffused
// pictures of 8 bits: a photographed panorama, a photographed desk, a rendered box, a contact sheet, computed rings.
//     level           panorama     desk         box          sheet        rings
//     0 stored        2.56 149x    2.01 165x    1.69  56x    3.56 103x    4.93  65x
//     1               1.01  11x    1.10  12x    1.05   5x    1.03 8.9x    1.43 5.8x
//     2 (default)     1.02 8.6x    0.99 9.1x    1.05 3.6x    1.02 7.3x    1.42 4.2x
//     3               1.00 6.6x    0.98 7.1x    1.00 2.9x    1.01 5.5x    1.37 3.5x
//     4               1.02 3.0x    1.00 2.9x    1.00 1.1x    1.02 2.7x    1.09 2.3x
//     9               0.98 0.2x    0.99 0.5x    1.00 1.0x    0.97 0.2x    0.94 0.1x
// The rings are what the default is bad for: computed, without noise, the same everywhere. The panorama at level 2 is
// 25 megapixels a second. Codes of 16 bits (without dithering): level 2 is 1.00 to 1.08 of the size, 4 times as fast.
//
// Codes of up to 4 bits are patterns that do repeat, and differences only hide them: they are not filtered, and zlib
// looks for strings at every level. At level 3 they have 0.87 to 1.12 of the size of libpng's default, 1.37 in the
// worst case, 3.2 to 4.5 times as fast.

#include "core/parameters.h"

namespace emulsion {

inline constexpr ParameterRange kPngLevels = {0.0, 9.0};
inline constexpr int kDefaultPngLevel = 2;

/// In libpng's and zlib's words.
struct PngCompression {
    int level = 0;     ///< of zlib; 0 to 9
    int strategy = 0;  ///< Z_...
    int filters = 0;   ///< PNG_..., joined by |
    bool operator==(const PngCompression&) const = default;
};

/// 0: stored as they are. 1: Sub filter and run lengths. 2: Paeth filter and run lengths. 3: the filter that leaves
/// least, row by row, and run lengths. 4 to 9: the same filter, and strings by zlib's level of that number; 6 is what
/// libpng does if it isn't asked otherwise. Codes of up to 4 bits: no filter, and zlib's level of that number, but 3
/// for 2. \throws std::invalid_argument if the level is not in [0, 9].
[[nodiscard]] PngCompression png_compression(int level, int code_bits);

}  // namespace emulsion
