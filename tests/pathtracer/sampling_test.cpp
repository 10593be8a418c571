// Every routine that draws points, directions or lights against the density that it says it has: chi-square tests,
// which together raise a false alarm in one seed of a thousand. A new routine is one more line in every_case().

#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "core/random.h"
#include "pathtracer/emitters.h"
#include "pathtracer/vector_math.h"
#include "scene_text.h"
#include "support/density_check.h"

namespace emulsion::testing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFalseAlarm = 1e-3;

struct SamplingCase {
    std::string name;
    std::function<DensityCheckResult(Pcg32&)> check;
};
std::ostream& operator<<(std::ostream& out, const SamplingCase& sampling) { return out << sampling.name; }

std::array<float, 2> next_2d(Pcg32& random) {
    const float u = random.next_float();
    return {u, random.next_float()};
}

Direction direction_of(const Imath::V3f& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// `draw` maps two uniform numbers to a unit vector of density `pdf` per steradian, about +z.
SamplingCase direction_case(std::string name, const std::function<Imath::V3f(std::array<float, 2>)>& draw,
                            const DirectionDensity& pdf) {
    const auto check = [=](Pcg32& random) {
        return check_direction_density([&] { return direction_of(draw(next_2d(random))); }, pdf, {0, 0, 1});
    };
    return {std::move(name), check};
}

/// The same for a point of the unit disk, of density `pdf` per unit of area.
SamplingCase disk_case(std::string name, const std::function<std::array<float, 2>(std::array<float, 2>)>& draw,
                       const std::function<double(double, double)>& pdf) {
    // By squared radius and angle, which keep areas but for a factor of pi.
    const auto check = [=](Pcg32& random) {
        const auto sampler = [&]() -> std::optional<SquarePoint> {
            const auto point = draw(next_2d(random));
            const auto x = static_cast<double>(point[0]), y = static_cast<double>(point[1]);
            return SquarePoint{std::min(x * x + y * y, 1.0), 0.5 + 0.5 * std::atan2(y, x) / kPi};
        };
        const auto density = [&](const SquarePoint& point) {
            const double radius = std::sqrt(point[0]), angle = (2.0 * point[1] - 1.0) * kPi;
            return kPi * pdf(radius * std::cos(angle), radius * std::sin(angle));
        };
        return check_point_density(sampler, density);
    };
    return {std::move(name), check};
}

/// Directions in which a light's surface is seen under a smaller cosine count as nothing: where a light is sampled by
/// its area, its density is infinite at the outline, and no integral over bins would be exact.
constexpr float kLeastCosine = 0.05f;

/// Next-event estimation in a scene of nothing but lights, from a point in empty space: one of them is picked, and a
/// direction towards it drawn, which counts if the light is seen there.
class LightSampling {
  public:
    LightSampling(const Scene& scene, const Imath::V3f& from) : scene_(scene, 1), from_(from) {}

    [[nodiscard]] std::optional<Direction> draw(Pcg32& random) const {
        const double pick = static_cast<double>(random.next()) * 0x1p-32;
        const Emitter& emitter = scene_.emitters()[scene_.picker().pick(pick)];
        const EmitterSample light = sample(emitter.geometry, from_, next_2d(random));
        if (light.scale == 0.0f || grazing(light.to_light)) return std::nullopt;
        Ray shadow{from_, light.to_light};
        if (!light.infinite) shadow = {from_, light.target - from_, 1.0f - 1e-5f};
        std::uint8_t occluded = 0;
        scene_.accelerator().occluded({&shadow, 1}, {&occluded, 1});
        if (occluded != 0) return std::nullopt;
        return direction_of(light.to_light);
    }

    /// What a path that comes across the light by chance takes the density for.
    [[nodiscard]] double pdf(const Direction& along) const {
        const Imath::V3f direction(Imath::V3d(along[0], along[1], along[2]));
        const Met met = meet(direction);
        if (met.shape == nullptr) {
            double sum = 0.0;
            for (const std::uint32_t i : scene_.infinite_emitters()) sum += pdf(i, direction, {});
            return sum;
        }
        const float cosine = -direction.dot(met.point.geometric_normal);
        if (std::abs(cosine) < kLeastCosine || (!met.shape->two_sided && cosine < 0.0f)) return 0.0;
        return pdf(met.emitter, direction, met.point);
    }

  private:
    struct Met {
        const PreparedScene::PreparedShape* shape = nullptr;  // or nothing:
        std::uint32_t emitter = 0;
        SurfacePoint point;
    };
    [[nodiscard]] Met meet(const Imath::V3f& direction) const {
        const Ray ray{from_, direction};
        Hit hit;
        scene_.accelerator().intersect({&ray, 1}, {&hit, 1});
        if (hit.shape == Hit::kNone) return {};
        const auto& shape = scene_.shape(hit.shape);
        return {&shape, *shape.first_emitter + hit.primitive, surface_point(scene_, ray, hit)};
    }
    [[nodiscard]] bool grazing(const Imath::V3f& direction) const {
        const Met met = meet(direction);
        return met.shape != nullptr && std::abs(direction.dot(met.point.geometric_normal)) < kLeastCosine;
    }
    [[nodiscard]] double pdf(std::uint32_t i, const Imath::V3f& direction, const SurfacePoint& point) const {
        const Emitter& emitter = scene_.emitters()[i];
        return static_cast<double>(emitter.selection_probability) *
               static_cast<double>(
                   direction_pdf(emitter.geometry, from_, direction, point.position, point.geometric_normal));
    }

    PreparedScene scene_;
    Imath::V3f from_;
};

/// `axis`: about where the lights are.
SamplingCase lights_case(std::string name, const Scene& scene, const Imath::V3f& from, const Direction& axis) {
    const auto check = [=](Pcg32& random) {
        const LightSampling lights(scene, from);
        return check_direction_density([&] { return lights.draw(random); },
                                       [&](const Direction& along) { return lights.pdf(along); }, axis);
    };
    return {std::move(name), check};
}

enum class Sides { one, two };

/// A scene of one shape that shines.
Scene shining(const decltype(Shape::geometry)& geometry, Sides sides = Sides::one) {
    Scene scene;
    scene.materials = {DiffuseMaterial{ConstantSpectrum{0.0}}};
    scene.shapes = {{geometry, 0, AreaLight{{ConstantSpectrum{1.0}, 1.0}, sides == Sides::two, {}}}};
    return scene;
}

/// The same of a shape as scene files have it; both sides shine.
Scene parsed(const std::string& shape) {
    return parse_world("AreaLightSource \"diffuse\" \"bool twosided\" true " + shape);
}

Scene both(Scene scene, const Scene& other) {
    scene.shapes.insert(scene.shapes.end(), other.shapes.begin(), other.shapes.end());
    scene.lights.insert(scene.lights.end(), other.lights.begin(), other.lights.end());
    return scene;
}

Scene sky() {
    Scene scene;
    scene.lights = {UniformInfiniteLight{{ConstantSpectrum{0.02}, 1.0}}};
    return scene;
}

Sphere ellipsoid(const Imath::V3d& centre, double radius, const Imath::V3d& stretch = {1, 1, 1}) {
    Imath::M44d world_from_object;
    world_from_object.setScale(stretch);
    for (int i = 0; i < 3; ++i) world_from_object[3][i] = centre[i];
    return {world_from_object, radius, false};
}

Sphere inward(Sphere sphere) {
    sphere.flip_normal = true;
    return sphere;
}

/// Above the origin, facing it.
TriangleMesh panel() { return parallelogram({-1.1f, -0.9f, 2}, {0.3f, 2, 0.2f}, {2, 0.1f, 0.4f}); }

std::vector<SamplingCase> every_case() {
    const auto uniform = [](const Direction&) { return 0.25 / kPi; };
    const auto cosine = [](const Direction& d) { return std::max(0.0, d[2]) / kPi; };
    const auto disk = [](double, double) { return 1.0 / kPi; };
    const Sphere ball = ellipsoid({0.4, -0.3, 5}, 1.5), egg = ellipsoid({0.4, -0.3, 5}, 1.0, {2, 0.5, 1});
    return {
        disk_case("UniformDisk", uniform_disk, disk),
        direction_case("CosineHemisphere", cosine_hemisphere, cosine),
        direction_case("UniformSphere", uniform_sphere, uniform),
        lights_case("Panel", shining(panel()), {0, 0, 0}, {0, 0, 1}),
        lights_case("PanelCloseBy", shining(panel()), {0.2f, 0.1f, 1.9f}, {0, 0, 1}),
        lights_case("PanelAskance", shining(panel()), {4, 3, 1.5f}, {-4, -3, 0.7}),
        lights_case("PanelFromBehind", shining(panel(), Sides::two), {0, 0, 5}, {0, 0, -1}),
        lights_case("SphereFromOutside", shining(ball), {0, 0, 0}, {0.4, -0.3, 5}),
        lights_case("SphereAlmostTouched", shining(ball), {0.4f, -0.3f, 3.499f}, {0, 0, 1}),
        lights_case("SphereFarAway", shining(ball), {100, 50, -200}, {-99.6, -50.3, 205}),
        lights_case("SphereFromInside", shining(inward(ball)), {0.7f, -0.8f, 5.2f}, {0, 0, 1}),
        lights_case("EllipsoidFromOutside", shining(egg), {0, 0, 0}, {0.4, -0.3, 5}),
        lights_case("EllipsoidFromInside", shining(inward(egg)), {1.2f, -0.4f, 5.2f}, {0, 0, 1}),
        lights_case("EllipsoidOfTwoSides", shining(egg, Sides::two), {0, 0, 0}, {0.4, -0.3, 5}),
        lights_case("Disk", parsed(R"(Translate 0.3 0.2 2 Rotate 160 1 0 0 Shape "disk" "float radius" 1.2)"),
                    {0, 0, 0}, {0, 0, 1}),
        lights_case("Cylinder", parsed(R"(Translate 0.3 0.2 3 Rotate 70 1 0 0 Shape "cylinder")"), {0, 0, 0},
                    {0, 0, 1}),
        lights_case("BilinearPatch", parsed(R"(Shape "bilinearmesh" "point3 P" [-1 -1 2  -1 1 3  1 -3 3  1 2 2])"),
                    {0.5f, 0, 0}, {0, 0, 1}),
        lights_case("Sky", sky(), {0, 0, 0}, {0, 0, 1}),
        lights_case("SphereAndPanelUnderSky", both(both(shining(ball), shining(panel())), sky()), {2, 1, 1}, {0, 0, 1}),
    };
}

class Sampling : public ::testing::TestWithParam<SamplingCase> {};

TEST_P(Sampling, FollowsItsDensity) {
    const double level = sidak_level(kFalseAlarm, static_cast<int>(every_case().size()));
    const std::string& name = GetParam().name;
    Pcg32 random(1, std::accumulate(name.begin(), name.end(), std::uint64_t{0}));
    const DensityCheckResult result = GetParam().check(random);
    EXPECT_GT(result.p_value, level) << "chi-square " << result.statistic << " of " << result.degrees_of_freedom
                                     << " degrees of freedom; drawn " << result.drawn_share << ", integral "
                                     << result.integral;

    EXPECT_GT(result.degrees_of_freedom, 20.0) << "too few bins to tell anything";
}

std::string name_of(const ::testing::TestParamInfo<SamplingCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Every, Sampling, ::testing::ValuesIn(every_case()), name_of);

}  // namespace
}  // namespace emulsion::testing
