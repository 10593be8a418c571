#pragma once
// Scene files in the syntax of pbrt-v4 (https://pbrt.org/fileformat-v4), as far as they are supported.
//
//     scene       = { option | transform } "WorldBegin" { element | transform }
//     option      = ( "Camera" | "Film" | "Sampler" | "PixelFilter" | "Integrator" ) named
//     element     = "AttributeBegin" { element | transform } "AttributeEnd" | "ReverseOrientation"
//                 | ( "Shape" | "Material" | "LightSource" | "AreaLightSource" | "MakeNamedMaterial" ) named
//                 | "NamedMaterial" string
//                 | "Texture" string string named                   name, "float" or "spectrum", class
//     transform   = "Identity"
//                 | ( "Translate" | "Scale" ) numbers(3)
//                 | "Rotate" numbers(4)                             angle in degrees, axis
//                 | "LookAt" numbers(9)                             eye, look, up
//                 | ( "Transform" | "ConcatTransform" ) numbers(16) column by column
//     named       = string { parameter }
//     parameter   = declaration ( value | "[" value { value } "]" )
//     declaration = string of a type and a name: "float fov"
//     value       = number | string | "true" | "false"
//     numbers(n)  = n numbers, or "[" n numbers "]"
//
// The types are integer float bool string point2 vector2 point3 (point) vector3 (vector) normal (normal3) rgb blackbody
// spectrum. Tokens are separated by blanks, line ends and comments, which run from # to the end of the line.
// scene_tables.h lists the names that each directive takes and their parameters. What pbrt-v4 knows and we don't is an
// error that says so; nothing is skipped.
//
// Transformations multiply on the right of the current one, which is set back to the identity by WorldBegin and saved,
// with material, area light and orientation, by AttributeBegin. A directive before WorldBegin that is given twice
// replaces the earlier one, as in pbrt-v4, and is warned of. Named materials may be used before they are made.

#include <filesystem>
#include <string_view>

#include "pathtracer/scene.h"
#include "pathtracer/scene_source.h"

namespace emulsion {

/// \throws IoError if the file can't be read, and SceneError as parse_scene does.
[[nodiscard]] Scene read_scene(const std::filesystem::path& path);

/// `name` stands for the text in messages, and its folder is where files that the scene names are looked for.
/// \throws SceneError at the first thing that is wrong.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::filesystem::path& name);

}  // namespace emulsion
