#pragma once
// The parameters of one directive: "type name" value, or "type name" [ value ... ].
//
// Reading checks each against its declared type; checking against the table of the implementation then leaves nothing
// unknown, unsupported, wrongly typed, wrongly sized or out of range. The getters rely on that and only fetch.

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathVec.h>

#include "pathtracer/scene_color_space.h"
#include "pathtracer/scene_lexer.h"
#include "pathtracer/scene_tables.h"

namespace emulsion {

/// A type that a parameter may be declared with.
enum class DeclaredType {
    integer,
    real,
    boolean,
    string,
    point2,
    vector2,
    point3,
    vector3,
    normal,
    rgb,
    blackbody,
    spectrum,
    texture
};

/// The space of that name, in large or small letters.
/// \throws SceneError at `place` if there is none.
[[nodiscard]] ColorSpace color_space_of(const SourcePlace& place, std::string_view name);

struct SceneParameter {
    SourcePlace place;        ///< of the string that declares it
    SourcePlace first_value;  ///< of its first value
    DeclaredType type = DeclaredType::real;
    std::string name;
    std::vector<double> numbers;                ///< finite; of flags: 0 and 1; of points: x y z x y z ...
    std::vector<std::string> strings;           ///< of strings, textures, and spectra given by name
    ColorSpace color_space = ColorSpace::srgb;  ///< of the three numbers of an rgb parameter
};

struct ParameterList {
    std::string owner;  ///< in messages: sphere for Shape "sphere"
    SourcePlace place;  ///< of the string that names the owner
    std::vector<SceneParameter> parameters;
    ColorSpace color_space = ColorSpace::srgb;  ///< in force where the directive stands
};

/// Reads parameters until a token that can't begin one.
/// \throws SceneError for malformed ones, values that don't fit the declared type, and names given twice.
[[nodiscard]] std::vector<SceneParameter> read_parameters(Lexer& lexer);

/// The implementation of the list's owner; every parameter of the list is checked against its table.
/// \throws SceneError naming the token at fault.
const Implementation& check_parameters(const ImplementationTable& table, const ParameterList& list);

/// What Attribute directives give to those after them, by name: of two with one name the later.
using InheritedParameters = std::map<std::string, std::shared_ptr<const SceneParameter>>;

/// Whether an implementation of the table has a parameter of this name.
[[nodiscard]] bool knows_parameter(const ImplementationTable& table, std::string_view name) noexcept;

/// Adds those of `inherited` that the implementation of the list's owner knows and the list does not have.
void inherit_parameters(const ImplementationTable& table, ParameterList& list, const InheritedParameters& inherited);

/// Unset (nullptr) if the list has none of this name.
[[nodiscard]] const SceneParameter* find_parameter(const ParameterList& list, std::string_view name) noexcept;

/// Where value number `index` stands in the text, for messages.
[[nodiscard]] SourcePlace place_of_value(const SceneParameter& parameter, std::size_t index);

[[nodiscard]] double real_or(const ParameterList& list, std::string_view name, double otherwise) noexcept;
[[nodiscard]] int integer_or(const ParameterList& list, std::string_view name, int otherwise) noexcept;
[[nodiscard]] std::string string_or(const ParameterList& list, std::string_view name, std::string_view otherwise);
[[nodiscard]] Imath::V3d point_or(const ParameterList& list, std::string_view name,
                                  const Imath::V3d& otherwise) noexcept;

enum class Flag { off, on };
[[nodiscard]] Flag flag_or(const ParameterList& list, std::string_view name, Flag otherwise) noexcept;

}  // namespace emulsion
