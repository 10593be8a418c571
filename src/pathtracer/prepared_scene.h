#pragma once
// A scene made ready for rendering: hierarchy, spectra as tables, light sources as a list to pick from.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "pathtracer/accelerator.h"
#include "pathtracer/emitters.h"
#include "pathtracer/environment_map.h"
#include "pathtracer/light_powers.h"
#include "pathtracer/model_channels.h"
#include "pathtracer/prepared_instance.h"
#include "pathtracer/prepared_materials.h"
#include "pathtracer/scene.h"
#include "pathtracer/surface.h"
#include "spectrum/wavelength_sampler.h"

namespace emulsion {

class PreparedScene {
  public:
    /// Takes the scene over. `threads` as in parallel_for; renders of the scene use no more of them than this, since
    /// Embree keeps oneTBB to that number while it holds the scene. `many_triangles` is Accelerator's.
    /// \throws std::invalid_argument naming what is out of range; std::runtime_error if Embree fails.
    PreparedScene(Scene scene, int threads, const TransportModel& model = {},
                  std::size_t many_triangles = kManyTriangles);

    /// Prepares its spectra for another model; the rest stays.
    /// \throws std::invalid_argument as validate(TransportModel) does.
    void prepare_for(const TransportModel& model);
    /// Prepares its spectra for paths of these channels, which are of no model.
    void prepare_for(FixedChannels channels);
    /// Whether it is: for the last model that it was prepared for, and for wavelengths drawn without knowing the scene.
    [[nodiscard]] bool is_prepared_for(const TransportModel& model) const noexcept;
    /// Of the last model that it was prepared for, unless that is a spectral one.
    [[nodiscard]] const std::optional<FixedChannels>& channels() const noexcept { return channels_; }
    [[nodiscard]] const WavelengthSampler& wavelengths() const noexcept { return wavelengths_; }
    /// What its lights and surfaces are made of, each spectrum once.
    [[nodiscard]] SceneSpectra scene_spectra() const;

    /// What shading needs to know of one shape of the scene.
    struct PreparedShape {
        const TriangleMesh* mesh = nullptr;        ///< or
        const BilinearMesh* patches = nullptr;     ///< or
        std::unique_ptr<PreparedQuadric> quadric;  ///< one of the three
        std::uint32_t material = 0;
        std::optional<std::uint32_t> diffuse_table;  ///< of a diffuse material that is the same everywhere
        std::optional<std::uint32_t> first_emitter;  ///< that of triangle or patch i is this + i
        bool two_sided = false;
    };

    [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
    [[nodiscard]] Accelerator& accelerator() noexcept { return *accelerator_; }
    [[nodiscard]] const Accelerator& accelerator() const noexcept { return *accelerator_; }
    [[nodiscard]] const PreparedShape& shape(std::uint32_t i) const noexcept { return shapes_[i]; }
    [[nodiscard]] const PreparedInstance& instance(std::uint32_t i) const noexcept { return instances_[i]; }
    [[nodiscard]] const PreparedMaterials& materials() const noexcept { return *materials_; }
    [[nodiscard]] const SpectrumTables& spectra() const noexcept { return spectra_; }
    [[nodiscard]] const std::vector<Emitter>& emitters() const noexcept { return emitters_; }
    [[nodiscard]] const EmitterPicker& picker() const noexcept { return picker_; }
    /// Those that rays meet by leaving the scene.
    [[nodiscard]] const std::vector<std::uint32_t>& infinite_emitters() const noexcept { return infinite_emitters_; }

  private:
    void add_shape(const Shape& shape, LightPowers& powers);
    void add_area_light(const AreaLight& light, PreparedShape& shape, LightPowers& powers);
    void add_light(const Light& light, LightPowers& powers);

    [[nodiscard]] WavelengthImportance importance() const;

    Scene scene_;
    std::optional<TransportModel> model_;
    std::optional<FixedChannels> channels_;
    WavelengthSampler wavelengths_;
    std::unique_ptr<Accelerator> accelerator_;
    SpectrumTables spectra_;
    std::unique_ptr<PreparedMaterials> materials_;
    std::vector<PreparedShape> shapes_;
    std::vector<PreparedInstance> instances_;
    std::vector<std::unique_ptr<EnvironmentMap>> environment_maps_;
    std::vector<Emitter> emitters_;
    std::vector<double> flux_;  // of each emitter, in lm/683
    std::vector<std::uint32_t> infinite_emitters_;
    EmitterPicker picker_;
};

/// Where a ray has met anything but a triangle that belongs to no object.
[[nodiscard]] SurfacePoint surface_point_elsewhere(const PreparedScene& scene, const Ray& ray, const Hit& hit) noexcept;

/// Where a ray has met a shape of the scene. Inlined by force: the integrator is compiled for so many numbers of
/// wavelengths that the compiler's budget for the file runs out before it.
[[nodiscard, gnu::always_inline]] inline SurfacePoint surface_point(const PreparedScene& scene, const Ray& ray,
                                                                    const Hit& hit) noexcept {
    const TriangleMesh* const mesh = scene.shape(hit.shape).mesh;
    if (mesh == nullptr || hit.instance != Hit::kNone) return surface_point_elsewhere(scene, ray, hit);
    return surface_point(*mesh, hit);
}

}  // namespace emulsion
