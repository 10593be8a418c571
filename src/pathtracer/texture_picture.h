#pragma once
// Picture files, decoded as pbrt-v4 does, by the ending of the name:
//
//     .png          8 or 16 bits, decoded by the encoding asked for, sRGB by default
//     .jpg, .jpeg   always sRGB
//     .hdr          the numbers as they are: EXPOSURE, COLORCORR and PRIMARIES have no effect
//     .pfm          linear
//     .exr          the numbers as they are, in the space of the chromaticities: whiteLuminance has no effect. One
//                   channel is grey. X Y Z, which pbrt-v4 doesn't take, go to linear sRGB
//
// HDR, PFM and EXR are read by src/film. (stb_image 2.27, which reads PNG and JPEG, loops for ever on a truncated HDR.)

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/image.h"
#include "pathtracer/scene_color_space.h"
#include "spectrum/gamma_transfer.h"
#include "spectrum/linear_transfer.h"
#include "spectrum/srgb_transfer.h"

namespace emulsion {

/// Of the codes of PNG pictures.
using TextureEncoding = std::variant<SrgbTransfer, LinearTransfer, GammaTransfer>;

enum class PictureFormat { png, jpeg, radiance, pfm, exr };

/// By the ending of the name, whatever its case. \throws IoError for others.
[[nodiscard]] PictureFormat picture_format(const std::filesystem::path& path);

struct DecodedPicture {
    Image<RGB> rgb;  ///< linear; of grey pictures three times the same
    std::optional<Image<float>> alpha =
        std::nullopt;                     ///< decoded like the others; unset if there is none, or only ones
    ColorSpace space = ColorSpace::srgb;  ///< of rgb
    std::optional<TextureEncoding> byte_codes = std::nullopt;  ///< set if the file has codes of 8 bits, by these
    std::string note = {};  ///< what was taken otherwise than the file says; empty: nothing
};

/// `bytes` are those of the file; `encoding` matters to PNG only.
/// \throws IoError if they are no whole picture, and for NaN and infinite texels.
[[nodiscard]] DecodedPicture read_picture(const std::filesystem::path& path, std::string_view bytes,
                                          const TextureEncoding& encoding);

}  // namespace emulsion
