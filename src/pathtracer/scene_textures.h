#pragma once
// The Texture directive, and parameters that may name a texture:
//
//     Texture "bricks" "spectrum" "imagemap" "string filename" "bricks.png"
//     Material "diffuse" "texture reflectance" "bricks"
//
// Textures of numbers ("float") and of reflectances ("spectrum") have names of their own, as in pbrt-v4. A texture is
// used after it has been made; pbrt-v4 lets materials, but not textures, name one that comes later.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pathtracer/scene.h"
#include "pathtracer/scene_imagemap.h"
#include "pathtracer/scene_parameters.h"
#include "pathtracer/scene_spectra.h"
#include "pathtracer/texture_context.h"

namespace emulsion {

/// The two strings of a Texture directive before its class, which is the owner of the parameters.
struct TextureDeclaration {
    std::string name, kind;
    SourcePlace name_place, kind_place;
};

/// The named textures of a scene.
class SceneTextures {
  public:
    /// One evaluation of a texture may come to so many, itself included: without a limit, textures that use the one
    /// before twice would double the work with each.
    static constexpr int kMaxEvaluations = 256;

    /// Makes a texture, and adds it to the scene's unless it is the same as another or a constant.
    /// \throws SceneError for an unknown kind, class or parameter, a name that the kind has already, a picture that
    /// can't be read, and a texture of more than kMaxEvaluations.
    void make(const TextureDeclaration& declaration, const ParameterList& list, const TextureContext& context);

    /// A parameter of ValueKind::real_or_texture.
    /// \throws SceneError if it names no texture of numbers.
    [[nodiscard]] FloatParameter float_parameter(const SceneParameter& parameter) const;

    /// A parameter of ValueKind::spectrum_or_texture.
    /// \throws SceneError if it names no texture of reflectances, and as SpectrumReader::reflectance.
    [[nodiscard]] ReflectanceParameter reflectance_parameter(const SceneParameter& parameter,
                                                             SpectrumReader& spectra) const;

    /// The same of the list's parameter `name`, or a constant if the list has none.
    [[nodiscard]] FloatParameter float_or(const ParameterList& list, std::string_view name, double otherwise) const;
    [[nodiscard]] ReflectanceParameter reflectance_or(const ParameterList& list, std::string_view name,
                                                      double otherwise, SpectrumReader& spectra) const;

  private:
    template <class Parameter>
    struct Named {
        Parameter value;
        SourcePlace made;
    };
    /// The textures of one kind.
    template <class Parameter, class Texture>
    struct Kind {
        std::string_view name;
        std::vector<Texture> Scene::*textures;
        std::map<std::string, Named<Parameter>> named = {};
        std::vector<int> evaluations = {};  // that each of the scene's textures comes to

        [[nodiscard]] int count(const Parameter& parameter) const noexcept;
    };
    using FloatKind = Kind<FloatParameter, FloatTexture>;
    using ReflectanceKind = Kind<ReflectanceParameter, ReflectanceTexture>;

    template <class Parameter, class Texture, class OtherKind>
    [[nodiscard]] static const Parameter& look_up(const SceneParameter& parameter, const Kind<Parameter, Texture>& kind,
                                                  const OtherKind& other);
    template <class Parameter>
    [[nodiscard]] Parameter operand(const ParameterList& list, std::string_view name, double otherwise,
                                    const TextureContext& context) const;
    template <class Parameter, class Texture>
    void make(Kind<Parameter, Texture>& kind, const TextureDeclaration& declaration, const ParameterList& list,
              const TextureContext& context);
    template <class Parameter, class Texture>
    [[nodiscard]] Parameter read(Kind<Parameter, Texture>& kind, const ParameterList& list,
                                 const TextureContext& context);
    template <class Parameter, class Texture>
    [[nodiscard]] Parameter read_scale(Kind<Parameter, Texture>& kind, const ParameterList& list,
                                       const TextureContext& context);
    template <class Parameter, class Texture>
    [[nodiscard]] Parameter add(Kind<Parameter, Texture>& kind, Texture texture, int evaluations,
                                const ParameterList& list, const TextureContext& context);

    FloatKind floats_{"float", &Scene::float_textures};
    ReflectanceKind reflectances_{"spectrum", &Scene::reflectance_textures};
    ImagemapReader imagemaps_;
};

}  // namespace emulsion
