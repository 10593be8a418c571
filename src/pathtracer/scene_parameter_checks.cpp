// Parameters against the table of the implementation that they are for.
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pathtracer/scene_parameters.h"

namespace emulsion {

namespace {

struct KindRow {
    ValueKind kind;
    int components;
    std::string_view declared_as;  // in messages
};

constexpr auto kKinds = std::to_array<KindRow>({
    {ValueKind::integer, 1, "integer"},
    {ValueKind::real, 1, "float"},
    {ValueKind::boolean, 1, "bool"},
    {ValueKind::string, 1, "string"},
    {ValueKind::point2, 2, "point2"},
    {ValueKind::vector2, 2, "vector2"},
    {ValueKind::point3, 3, "point3"},
    {ValueKind::vector3, 3, "vector3"},
    {ValueKind::normal, 3, "normal"},
    {ValueKind::spectrum, 1, "rgb, blackbody or spectrum"},
    {ValueKind::real_or_spectrum, 1, "float, rgb, blackbody or spectrum"},
    {ValueKind::real_or_texture, 1, "float or texture"},
    {ValueKind::spectrum_or_texture, 1, "rgb, blackbody, spectrum or texture"},
});

const KindRow& row_of(ValueKind kind) noexcept {
    for (const KindRow& row : kKinds) {
        if (row.kind == kind) return row;
    }
    return kKinds[0];
}

std::string_view name_of(DeclaredType type) noexcept {
    constexpr std::array<std::string_view, 13> kNames = {"integer",   "float",    "bool",    "string", "point2",
                                                         "vector2",   "point3",   "vector3", "normal", "rgb",
                                                         "blackbody", "spectrum", "texture"};
    return kNames[static_cast<std::size_t>(type)];
}

bool fits(DeclaredType type, ValueKind kind) noexcept {
    using D = DeclaredType;
    switch (kind) {
        case ValueKind::integer:
        case ValueKind::real:
            return type == D::integer || type == D::real;
        case ValueKind::spectrum:
            return type == D::rgb || type == D::blackbody || type == D::spectrum;
        case ValueKind::real_or_spectrum:
            return fits(type, ValueKind::real) || fits(type, ValueKind::spectrum);
        case ValueKind::real_or_texture:
            return type == D::texture || fits(type, ValueKind::real);
        case ValueKind::spectrum_or_texture:
            return type == D::texture || fits(type, ValueKind::spectrum);
        default:
            return name_of(type) == row_of(kind).declared_as;
    }
}

void check_type(const SceneParameter& parameter, const ParameterSpec& spec, const std::string& of) {
    if (fits(parameter.type, spec.kind)) return;
    const std::string found = fmt::format("type {} of {}", quote(name_of(parameter.type)), of);
    const std::string expected(row_of(spec.kind).declared_as);
    const bool pbrt_takes_it = parameter.type == DeclaredType::texture && spec.kind == ValueKind::spectrum;
    throw SceneError(parameter.place, found,
                     pbrt_takes_it
                         ? "a supported one (known to pbrt-v4 and not yet supported here; supported: " + expected + ")"
                         : expected);
}

/// Spectra have sizes of their own (scene_spectra.h).
void check_count(const SceneParameter& parameter, const ParameterSpec& spec, const std::string& of) {
    if (spec.count == 1 && fits(parameter.type, ValueKind::spectrum)) return;
    const std::size_t components = row_of(spec.kind).components;
    const std::size_t count = parameter.numbers.size() + parameter.strings.size();
    const std::size_t wanted = components * spec.count;
    if (spec.count > 0 ? count == wanted : count % components == 0) return;
    throw SceneError(parameter.place, fmt::format("{} value{} for {}", count, count == 1 ? "" : "s", of),
                     spec.count > 0 ? fmt::format("{}", wanted) : fmt::format("a multiple of {}", components));
}

/// What a number should have been; empty if it is right.
std::string_view range_violated(double value, const ParameterSpec& spec) noexcept {
    constexpr double kLargest = std::numeric_limits<int>::max(), kSmallest = std::numeric_limits<int>::min();
    const bool whole = value == std::trunc(value) && value <= kLargest && value >= kSmallest;
    if (spec.kind == ValueKind::integer && !whole) return "a whole number of at most 32 bits";
    if (spec.range == ValueRange::positive && !(value > 0.0)) return "a number above 0";
    if (spec.range == ValueRange::not_negative && !(value >= 0.0)) return "0 or a number above";
    return {};
}

std::string shown(double value, ValueKind kind) {
    return kind == ValueKind::boolean ? fmt::format("{}", value != 0.0) : fmt::format("{}", value);
}

void check_range(const SceneParameter& parameter, const ParameterSpec& spec, const std::string& of) {
    for (std::size_t i = 0; i < parameter.numbers.size(); ++i) {
        const double value = parameter.numbers[i];
        std::string expected(range_violated(value, spec));
        if (spec.only && value != *spec.only) {
            expected = shown(*spec.only, spec.kind) + " (others are known to pbrt-v4 and not yet supported here)";
        }
        if (expected.empty()) continue;
        throw SceneError(place_of_value(parameter, i), fmt::format("{} for {}", shown(value, spec.kind), of), expected);
    }
}

void check_choices(const SceneParameter& parameter, const ParameterSpec& spec) {
    if (spec.choices.empty()) return;
    static_cast<void>(
        supported_row<KnownName>(place_of_value(parameter, 0), {spec.name}, parameter.strings.front(), spec.choices));
}

}  // namespace

const Implementation& check_parameters(const ImplementationTable& table, const ParameterList& list) {
    const auto& implementation =
        supported_row<Implementation>(list.place, {table.noun}, list.owner, table.implementations);
    const std::string of_owner = fmt::format(" of {} \"{}\"", table.noun, list.owner);
    for (const SceneParameter& parameter : list.parameters) {
        const auto& spec = supported_row<ParameterSpec>(parameter.place, {"parameter", of_owner}, parameter.name,
                                                        implementation.parameters);
        const std::string of = fmt::format("parameter \"{}\"{}", spec.name, of_owner);
        check_type(parameter, spec, of);
        check_count(parameter, spec, of);
        check_range(parameter, spec, of);
        check_choices(parameter, spec);
    }
    return implementation;
}

}  // namespace emulsion
