#pragma once
// Picture files to linear texels, as pbrt-v4 takes them: by the ending of the name,
//
//     .png          8 or 16 bits, decoded by the encoding asked for, sRGB by default
//     .jpg, .jpeg   always sRGB
//     .hdr          the numbers as they are: EXPOSURE, COLORCORR and PRIMARIES have no effect
//     .pfm          linear
//     .exr          linear, without whiteLuminance; from the file's primaries to those of sRGB, while pbrt-v4 makes
//                   spectra of the file's own colours if it knows their space
//
// HDR, PFM and EXR are read by src/film. (stb_image 2.27, which reads PNG and JPEG, loops for ever on a truncated HDR.)

#include <filesystem>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/image.h"
#include "pathtracer/scene_texture.h"
#include "spectrum/gamma_transfer.h"
#include "spectrum/linear_transfer.h"
#include "spectrum/srgb_transfer.h"

namespace emulsion {

/// Of the codes of PNG pictures.
using TextureEncoding = std::variant<SrgbTransfer, LinearTransfer, GammaTransfer>;

enum class PictureFormat { png, jpeg, radiance, pfm, exr };

/// By the ending of the name, whatever its case. \throws IoError for others.
[[nodiscard]] PictureFormat picture_format(const std::filesystem::path& path);

/// Linear sRGB, of grey pictures three times the same. `bytes` are those of the file.
/// \throws IoError if they are no whole picture, and for NaN and infinite texels.
[[nodiscard]] Image<RGB> read_rgb_texels(const std::filesystem::path& path, std::string_view bytes,
                                         const TextureEncoding& encoding = {});

/// Numbers: those of grey pictures; alpha, decoded like the other channels, if there is one and it is not 1 everywhere;
/// else the mean of red, green and blue. Of a picture that is not filtered (TextureFilter::nearest) red, which is what
/// pbrt-v4 takes there.
/// \throws IoError likewise.
[[nodiscard]] Image<float> read_number_texels(const std::filesystem::path& path, std::string_view bytes,
                                              const TextureEncoding& encoding, TextureFilter filter);

}  // namespace emulsion
