#pragma once
// Texture "imagemap": picture files as textures.

#include <map>
#include <memory>
#include <string>

#include "pathtracer/scene_parameters.h"
#include "pathtracer/scene_texture.h"
#include "pathtracer/texture_context.h"

namespace emulsion {

/// Where a texture's points lie on it, by the parameters that imagemap and checkerboard have in common.
/// \throws SceneError if the current transformation can't be undone.
[[nodiscard]] TextureMapping read_texture_mapping(const ParameterList& list, const TextureContext& context);

/// Those of a checkerboard in three dimensions. \throws SceneError likewise.
[[nodiscard]] SolidTextureMapping read_solid_mapping(const ParameterList& list, const TextureContext& context);

/// Reads the pictures of one scene, each once for each way in which its values are taken.
class ImagemapReader {
  public:
    /// Filters that take the ray's footprint do as if it were small (texture_lookup.h), and an encoding of a picture
    /// that is no PNG for the picture's own; the scene's warnings say so.
    /// \throws SceneError for a picture that can't be read.
    template <class Texel>
    [[nodiscard]] ImageTexture<Texel> read(const ParameterList& list, const TextureContext& context);

  private:
    template <class Texel>
    using Images = std::map<std::string, std::shared_ptr<const TextureImage<Texel>>>;
    template <class Texel>
    [[nodiscard]] Images<Texel>& images() noexcept;
    [[nodiscard]] TextureFilter read_filter(const ParameterList& list, const TextureContext& context);

    Images<float> number_images_;
    Images<RGB> rgb_images_;
    bool warned_of_filter_ = false;
};

extern template ImageTexture<float> ImagemapReader::read(const ParameterList&, const TextureContext&);
extern template ImageTexture<RGB> ImagemapReader::read(const ParameterList&, const TextureContext&);

}  // namespace emulsion
