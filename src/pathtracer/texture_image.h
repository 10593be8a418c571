#pragma once
// Picture files to texels that are looked up, as pbrt-v4 takes them. texture_picture.h has the formats.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/color.h"
#include "core/image.h"
#include "pathtracer/scene_texture.h"
#include "pathtracer/texture_picture.h"

namespace emulsion {

struct RgbTexels {
    Image<RGB> texels;                    ///< linear, of grey pictures three times the same
    ColorSpace space = ColorSpace::srgb;  ///< of them
    std::string note;                     ///< what was taken otherwise than the file says; empty: nothing
};

/// `bytes` are those of the file. With a `wrap` the texels are those of a texture that goes on so beyond its borders,
/// enlarged to sides of powers of two (texture_enlarge.h), as pbrt-v4 looks textures up; codes of 8 bits stay such.
/// \throws IoError if they are no whole picture, and for NaN and infinite texels.
[[nodiscard]] RgbTexels read_rgb_texels(const std::filesystem::path& path, std::string_view bytes,
                                        const TextureEncoding& encoding = {},
                                        std::optional<TextureWrap> wrap = std::nullopt);

/// Numbers: those of grey pictures; alpha, decoded like the other channels, if there is one and it is not 1 everywhere;
/// else the mean of red, green and blue. Of a picture that is looked up texel by texel (TextureFilter::nearest and
/// gaussian) red, which is what pbrt-v4 takes there. No space matters to them.
/// \throws IoError likewise.
[[nodiscard]] Image<float> read_number_texels(const std::filesystem::path& path, std::string_view bytes,
                                              const TextureEncoding& encoding, TextureFilter filter,
                                              std::optional<TextureWrap> wrap = std::nullopt);

}  // namespace emulsion
