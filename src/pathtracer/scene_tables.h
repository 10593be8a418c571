#pragma once
// What scene files may say: for each kind of directive the implementations that pbrt-v4 has, and for those that we
// support the parameters that pbrt-v4 has. To support one more, write it into its table and read it where its kind is
// made. What pbrt-v4 does not know is marked as ours. Source of names: the pbrt-v4 file format,
// https://pbrt.org/fileformat-v4.

#include <optional>
#include <span>
#include <string_view>

#include "pathtracer/scene_names.h"

namespace emulsion {

/// What a parameter is, whatever type it was declared with.
enum class ValueKind {
    integer,
    real,
    boolean,
    string,
    point2,
    vector2,
    point3,
    vector3,
    normal,
    spectrum,
    real_or_spectrum,
    real_or_texture,
    spectrum_or_texture
};

enum class ValueRange { any, positive, not_negative };

struct ParameterSpec {
    std::string_view name;
    ValueKind kind = ValueKind::real;
    int count = 1;                       ///< values (points, ...) that it holds; 0: any number but none
    ValueRange range = ValueRange::any;  ///< of numbers
    Support support = Support::here;
    std::optional<double> only = std::nullopt;  ///< the one number (or 0/1 for a flag) that we support
    std::span<const KnownName> choices = {};    ///< of a string; empty: any
    bool is_ignored = false;                    ///< read and checked, and of no effect on the picture
};

/// One value of a directive's first string: Shape "sphere".
struct Implementation {
    std::string_view name;
    std::span<const ParameterSpec> parameters = {};
    Support support = Support::here;
    std::string_view taken_as = {};  ///< the implementation that stands for it, with the same picture; empty: itself
    std::string_view advice = {};    ///< what to do if it is not supported, for its error
};

/// A kind of directive that takes a name and parameters.
struct ImplementationTable {
    std::string_view noun;  ///< in messages: "shape"
    std::span<const Implementation> implementations;
};

[[nodiscard]] const ImplementationTable& camera_table() noexcept;
[[nodiscard]] const ImplementationTable& film_table() noexcept;
[[nodiscard]] const ImplementationTable& sampler_table() noexcept;
[[nodiscard]] const ImplementationTable& filter_table() noexcept;
[[nodiscard]] const ImplementationTable& integrator_table() noexcept;
[[nodiscard]] const ImplementationTable& accelerator_table() noexcept;
[[nodiscard]] const ImplementationTable& float_texture_table() noexcept;
[[nodiscard]] const ImplementationTable& reflectance_texture_table() noexcept;
[[nodiscard]] const ImplementationTable& material_table() noexcept;
[[nodiscard]] const ImplementationTable& area_light_table() noexcept;
[[nodiscard]] const ImplementationTable& light_table() noexcept;
[[nodiscard]] const ImplementationTable& shape_table() noexcept;

}  // namespace emulsion
