#include "pathtracer/scene_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Imath/ImathMatrixAlgo.h>
#include <fmt/format.h>

#include "pathtracer/scene_mesh.h"

namespace emulsion {

namespace {

std::optional<Geometry> read_sphere(const ParameterList& list, const ShapeFrame& frame, std::vector<std::string>&) {
    const double radius = real_or(list, "radius", 1.0);
    for (const std::string_view end : {"zmin", "zmax"}) {
        const bool low = end == "zmin";
        const SceneParameter* const parameter = find_parameter(list, end);
        const double z = real_or(list, end, low ? -radius : radius);
        if (low ? z <= -radius : z >= radius) continue;
        throw SceneError(parameter->first_value, fmt::format(R"({} for parameter "{}" of shape "sphere")", z, end),
                         fmt::format("{} or {} (others are known to pbrt-v4 and not yet supported here)",
                                     low ? -radius : radius, low ? "below" : "above"));
    }
    const Imath::M44d& m = frame.world_from_object;
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = Imath::V3d(m[0][axis], m[1][axis], m[2][axis]).length() * radius + std::abs(m[3][axis]);
        if (reach <= std::numeric_limits<float>::max()) continue;
        throw SceneError(list.place, fmt::format("a sphere that reaches to {:g} in world space", reach),
                         "coordinates that single precision holds");
    }
    return Sphere{frame.world_from_object, radius, frame.orientation == Orientation::reversed};
}

struct ShapeReader {
    std::string_view name;
    std::optional<Geometry> (*read)(const ParameterList&, const ShapeFrame&, std::vector<std::string>&);
};
constexpr auto kReaders = std::to_array<ShapeReader>(
    {{"trianglemesh", read_triangle_mesh}, {"bilinearmesh", read_bilinear_mesh}, {"sphere", read_sphere}});

/// Surface of the ellipsoid with half axes a >= b >= c > 0.
/// Source: DLMF 19.33.2, https://dlmf.nist.gov/19.33
double ellipsoid_area(double a, double b, double c) {
    b /= a;
    c /= a;
    const double sin_phi = std::sqrt((1.0 - c) * (1.0 + c));
    const bool is_disk = c < 1e-8, is_ball = sin_phi < 1e-6;  // limits, right to 1e-12
    double area = b + c * c;
    if (is_disk) area = b;
    if (!is_disk && !is_ball) {
        const double k2 = ((b - c) * (b + c)) / (b * b * sin_phi * sin_phi);
        const double k = std::sqrt(std::clamp(k2, 0.0, 1.0)), phi = std::acos(c);
        const double integrals = std::ellint_2(k, phi) * sin_phi * sin_phi + std::ellint_1(k, phi) * c * c;
        area = c * c + b * integrals / sin_phi;
    }
    return 2.0 * std::numbers::pi * area * a * a;
}

double area_of(const Sphere& sphere) {
    Imath::M33d linear, u, v;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) linear[row][column] = sphere.world_from_object[row][column];
    }
    Imath::V3d stretch;  // singular values, largest first
    Imath::jacobiSVD(linear, u, stretch, v, 1e-15, true);
    const double r = sphere.radius;
    return ellipsoid_area(r * std::abs(stretch.x), r * std::abs(stretch.y), r * std::abs(stretch.z));
}

double area_of(const TriangleMesh& mesh) {
    double area = 0.0;
    for (const auto& triangle : mesh.triangle) area += 0.5 * edge_cross(mesh, triangle).length();
    return area;
}

}  // namespace

std::optional<Geometry> read_shape(const ParameterList& list, const ShapeFrame& frame,
                                   std::vector<std::string>& warnings) {
    check_parameters(shape_table(), list);
    return supported_row<ShapeReader>(list.place, {"shape"}, list.owner, kReaders).read(list, frame, warnings);
}

double world_area(const Geometry& geometry) {
    return std::visit([](const auto& shape) { return area_of(shape); }, geometry);
}

}  // namespace emulsion
