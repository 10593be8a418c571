#pragma once
// The state that directives act on, and the scene that grows from it. Knows nothing of tokens but their places.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Imath/ImathMatrix.h>

#include "pathtracer/scene.h"
#include "pathtracer/scene_files.h"
#include "pathtracer/scene_lights.h"
#include "pathtracer/scene_options.h"
#include "pathtracer/scene_shapes.h"
#include "pathtracer/scene_spectra.h"
#include "pathtracer/scene_textures.h"

namespace emulsion {

/// What AttributeBegin saves and AttributeEnd brings back. Small: scenes nest it deeply.
struct GraphicsState {
    ShapeFrame frame;
    int material = -1;  ///< index into Scene::materials; -1: pbrt-v4's default
    std::shared_ptr<const AreaLightSource> area_light;
};

enum class SceneBlock { options, world };

/// Member functions are named after directives, and throw SceneError naming the token at fault. `place` is that of the
/// directive.
class SceneBuilder {
  public:
    explicit SceneBuilder(std::filesystem::path folder) : files_(std::move(folder)), spectra_(files_) {}
    SceneBuilder(const SceneBuilder&) = delete;
    SceneBuilder& operator=(const SceneBuilder&) = delete;
    ~SceneBuilder() = default;

    [[nodiscard]] SceneBlock block() const noexcept { return block_; }

    /// Sets the current transformation.
    void transform(const SourcePlace& place, const Imath::M44d& matrix);
    /// Puts a transformation before the current one: points meet `matrix` first.
    void concat_transform(const SourcePlace& place, const Imath::M44d& matrix);

    void camera(const SourcePlace& place, const ParameterList& list);
    void film(const SourcePlace& place, const ParameterList& list);
    void sampler(const SourcePlace& place, const ParameterList& list);
    void pixel_filter(const SourcePlace& place, const ParameterList& list);
    void integrator(const SourcePlace& place, const ParameterList& list);
    void world_begin(const SourcePlace& place);

    void attribute_begin(const SourcePlace& place);
    void attribute_end(const SourcePlace& place);
    void reverse_orientation() noexcept;
    void material(const SourcePlace& place, const ParameterList& list);
    void make_named_material(const SourcePlace& place, ParameterList list);
    void named_material(const SourcePlace& place, const std::string& name);
    void texture(const TextureDeclaration& declaration, const ParameterList& list);
    void area_light_source(const SourcePlace& place, const ParameterList& list);
    void light_source(const SourcePlace& place, const ParameterList& list);
    void shape(const SourcePlace& place, const ParameterList& list);

    /// The scene, at the end of the text.
    [[nodiscard]] Scene finish(const SourcePlace& end);
    /// The files that the scene names.
    [[nodiscard]] SceneFiles& files() noexcept { return files_; }

  private:
    struct NamedMaterial {
        int material = 0;  // the slot in Scene::materials that is kept for it
        std::optional<SourcePlace> made, first_use;
    };
    struct SavedState {
        GraphicsState state;
        SourcePlace begin;
    };

    void note_option(const SourcePlace& place, const std::string& directive);
    [[nodiscard]] Material read_material(const ParameterList& list);
    [[nodiscard]] int add_material(Material material);
    void add_shape(Geometry geometry);
    [[nodiscard]] NamedMaterial& named_slot(const std::string& name);
    void check_named_materials() const;
    void check_mixes() const;
    /// Rays pass them, so they need not be there. pbrt-v4's path integrator lets them cast shadows; ours does not.
    void leave_out_interfaces(std::vector<Shape>& shapes);
    void warn(const SourcePlace& place, const std::string& what);

    Scene scene_;
    double exposure_time_s_ = 1.0;  // of the camera
    SceneFiles files_;
    SpectrumReader spectra_;
    SceneTextures textures_;
    SceneBlock block_ = SceneBlock::options;
    GraphicsState state_;
    std::vector<SavedState> saved_;
    std::optional<SourcePlace> world_begin_;
    std::map<std::string, SourcePlace> options_seen_;
    std::map<std::string, NamedMaterial> named_materials_;
    int default_material_ = -1;
};

}  // namespace emulsion
