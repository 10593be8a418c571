#pragma once
// The state that directives act on, and the scene that grows from it. Knows nothing of tokens but their places.

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Imath/ImathMatrix.h>

#include "pathtracer/scene.h"
#include "pathtracer/scene_cameras.h"
#include "pathtracer/scene_files.h"
#include "pathtracer/scene_global_options.h"
#include "pathtracer/scene_lights.h"
#include "pathtracer/scene_options.h"
#include "pathtracer/scene_shapes.h"
#include "pathtracer/scene_spectra.h"
#include "pathtracer/scene_textures.h"
#include "pathtracer/scene_warnings.h"

namespace emulsion {

/// Which of the two transformations directives change: as the shutter opens, as it closes, or both.
enum class ActiveTransform { all, start_time, end_time };

/// What an Attribute directive gives parameters to.
enum class AttributeTarget { shape, light, material, medium, texture };
inline constexpr std::size_t kAttributeTargets = 5;

/// What AttributeBegin saves and AttributeEnd brings back. Small: scenes nest it deeply.
struct GraphicsState {
    ShapeFrame frame;                      ///< as the shutter opens
    Imath::M44d world_from_object_at_end;  ///< and as it closes
    ActiveTransform active = ActiveTransform::all;
    ColorSpace color_space = ColorSpace::srgb;
    /// By AttributeTarget; null: none. States share them: they may be changed by who holds them alone.
    std::array<std::shared_ptr<InheritedParameters>, kAttributeTargets> attributes;
    int material = -1;  ///< index into Scene::materials; -1: pbrt-v4's default
    std::shared_ptr<const AreaLightSource> area_light;
};

enum class SceneBlock { options, world };

/// Member functions are named after directives, and throw SceneError naming the token at fault. `place` is that of the
/// directive, unless it says otherwise.
class SceneBuilder {
  public:
    explicit SceneBuilder(std::filesystem::path folder) : files_(std::move(folder)), spectra_(files_, warnings_) {}
    SceneBuilder(const SceneBuilder&) = delete;
    SceneBuilder& operator=(const SceneBuilder&) = delete;
    ~SceneBuilder() = default;

    [[nodiscard]] SceneBlock block() const noexcept { return block_; }
    [[nodiscard]] ColorSpace color_space() const noexcept { return state_.color_space; }

    // --- Anywhere (scene_builder_state.cpp)

    /// Sets the current transformation.
    void transform(const SourcePlace& place, const Imath::M44d& matrix);
    /// Puts a transformation before the current one: points meet `matrix` first.
    void concat_transform(const SourcePlace& place, const Imath::M44d& matrix);
    void active_transform(ActiveTransform active) noexcept { state_.active = active; }
    void coordinate_system(const std::string& name);
    void coord_sys_transform(const SourcePlace& place_of_name, const std::string& name);
    void color_space(const SourcePlace& place_of_name, const std::string& name);
    void attribute(const SourcePlace& place, ParameterList list);
    void medium_interface(const SourcePlace& place_of_name, const std::string& name);
    void option(const Token& name, const Token& value);

    // --- Before WorldBegin

    void camera(const SourcePlace& place, const ParameterList& list);
    void film(const SourcePlace& place, const ParameterList& list);
    void sampler(const SourcePlace& place, const ParameterList& list);
    void pixel_filter(const SourcePlace& place, const ParameterList& list);
    void integrator(const SourcePlace& place, const ParameterList& list);
    void accelerator(const SourcePlace& place, const ParameterList& list);
    void world_begin(const SourcePlace& place);

    // --- After it

    void attribute_begin(const SourcePlace& place);
    void attribute_end(const SourcePlace& place);
    void transform_begin(const SourcePlace& place);
    void transform_end(const SourcePlace& place);
    void object_begin(const SourcePlace& place, const std::string& name);
    void object_end(const SourcePlace& place);
    void object_instance(const SourcePlace& place, const SourcePlace& place_of_name, const std::string& name);
    void reverse_orientation() noexcept;
    void material(const SourcePlace& place, ParameterList list);
    void make_named_material(const SourcePlace& place, ParameterList list);
    void named_material(const SourcePlace& place, const std::string& name);
    void texture(const TextureDeclaration& declaration, ParameterList list);
    void area_light_source(const SourcePlace& place, ParameterList list);
    void light_source(const SourcePlace& place, ParameterList list);
    void shape(const SourcePlace& place, ParameterList list);

    /// Between the two, directives act on a copy of the graphics state, which is thrown away at the end. Blocks can't
    /// cross either.
    void import_begin();
    void import_end();

    /// The scene, at the end of the text.
    [[nodiscard]] Scene finish(const SourcePlace& end);
    /// The files that the scene names.
    [[nodiscard]] SceneFiles& files() noexcept { return files_; }

  private:
    struct NamedMaterial {
        int material = 0;  // the slot in Scene::materials that is kept for it
        std::optional<SourcePlace> made, first_use;
    };
    enum class BlockKind { attribute, object };
    struct OpenBlock {
        GraphicsState outside;
        SourcePlace begin;
        BlockKind kind;
        std::string_view directive;  // that began it, less its "Begin"
    };
    /// As the shutter opens and as it closes.
    using CoordinateSystem = std::array<Imath::M44d, 2>;
    struct OpenImport {
        GraphicsState outside;
        std::vector<OpenBlock> blocks;
        std::map<std::string, CoordinateSystem> coordinate_systems;
    };
    struct InstanceUse {
        std::string object;
        SourcePlace place_of_name;
        Imath::M44d world_from_object;
    };

    [[nodiscard]] Imath::M44d from_camera_position(const Imath::M44d& world_from_object) const;
    void note_option(const SourcePlace& place, const std::string& directive);
    /// Sets the active transformations to what `change` makes of them.
    template <class Change>
    void change_transforms(const SourcePlace& place, const Change& change);
    [[nodiscard]] bool is_moving() const noexcept;
    void require_rest(const SourcePlace& place, std::string_view what) const;
    void warn_of_motion(const SourcePlace& place, std::string_view what);
    void begin_block(const SourcePlace& place, BlockKind kind, std::string_view directive);
    void end_block(const SourcePlace& place, BlockKind kind, std::string_view directive);
    void require_closed_blocks() const;
    void inherit(AttributeTarget target, const ImplementationTable& table, ParameterList& list) const;
    [[nodiscard]] Material read_material(const ParameterList& list);
    [[nodiscard]] int add_material(Material material);
    void add_shape(Geometry geometry);
    [[nodiscard]] NamedMaterial& named_slot(const std::string& name);
    void check_named_materials() const;
    void check_mixes() const;
    /// Rays pass them, so they need not be there. pbrt-v4's path integrator lets them cast shadows; ours does not.
    void leave_out_interfaces(std::vector<Shape>& shapes);
    void resolve_instances();
    void warn(const SourcePlace& place, const std::string& what) { warnings_.add(place, what); }

    Scene scene_;
    SceneWarnings warnings_;
    double exposure_time_s_ = 1.0;  // of the camera
    std::optional<int> sampler_seed_;
    GlobalOptions options_;
    SceneFiles files_;
    SpectrumReader spectra_;
    SceneTextures textures_;
    SceneBlock block_ = SceneBlock::options;
    GraphicsState state_;
    std::vector<OpenBlock> open_blocks_;
    std::vector<OpenImport> open_imports_;
    std::map<std::string, CoordinateSystem> coordinate_systems_;
    std::optional<SourcePlace> world_begin_;
    std::map<std::string, SourcePlace> options_seen_;
    std::map<std::string, NamedMaterial> named_materials_;
    int default_material_ = -1;
    std::map<std::string, std::size_t> objects_;  // indices into Scene::objects
    std::vector<SourcePlace> object_places_;
    // Where objects begin, in the world of the file: their shapes are counted from there, for precision.
    std::vector<Imath::V3d> object_origins_;
    std::optional<std::size_t> open_object_;
    std::vector<InstanceUse> instance_uses_;
    bool warned_of_transform_begin_ = false;
};

}  // namespace emulsion
