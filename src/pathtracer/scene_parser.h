#pragma once
// Scene files in the syntax of pbrt-v4 (https://pbrt.org/fileformat-v4), as far as they are supported.
//
//     scene       = { option | anywhere } "WorldBegin" { element | anywhere }
//     option      = ( "Camera" | "Film" | "Sampler" | "PixelFilter" | "Integrator" | "Accelerator" ) named
//                 | "TransformTimes" numbers(2)                     start, end
//     element     = "AttributeBegin" { element | anywhere } "AttributeEnd" | "ReverseOrientation"
//                 | "TransformBegin" { element | anywhere } "TransformEnd"
//                 | "ObjectBegin" string { element | anywhere } "ObjectEnd" | "ObjectInstance" string
//                 | ( "Shape" | "Material" | "LightSource" | "AreaLightSource" | "MakeNamedMaterial" ) named
//                 | "NamedMaterial" string
//                 | "Texture" string string named                   name, "float" or "spectrum", class
//                 | "Import" string                                 file of elements
//     anywhere    = transform
//                 | "Include" string                                file of whole directives
//                 | "Attribute" named                               "shape", "light", "material", "medium", "texture"
//                 | "ColorSpace" string
//                 | "Option" string ( value | "[" value "]" )
//                 | "MediumInterface" string [ string ]             empty ones only
//     transform   = "Identity"
//                 | ( "Translate" | "Scale" ) numbers(3)
//                 | "Rotate" numbers(4)                             angle in degrees, axis
//                 | "LookAt" numbers(9)                             eye, look, up
//                 | ( "Transform" | "ConcatTransform" ) numbers(16) column by column
//                 | ( "CoordinateSystem" | "CoordSysTransform" ) string
//                 | "ActiveTransform" ( "All" | "StartTime" | "EndTime" )
//     named       = string { parameter }
//     parameter   = declaration ( value | "[" value { value } "]" )
//     declaration = string of a type and a name: "float fov"
//     value       = number | string | "true" | "false"
//     numbers(n)  = n numbers, or "[" n numbers "]"
//
// The types are integer float bool string point2 vector2 point3 (point) vector3 (vector) normal (normal3) rgb blackbody
// spectrum texture. Tokens are separated by blanks, line ends and comments, which run from # to the end of the line.
// scene_tables.h lists the names that each directive takes and their parameters. What pbrt-v4 knows and we don't is an
// error that says so; nothing is skipped without a word.
//
// Transformations multiply on the right of the current one, which is set back to the identity by WorldBegin and saved,
// with all else that directives leave for later ones (material, area light, orientation, attributes, colour space), by
// AttributeBegin. TransformBegin and TransformEnd are other names for AttributeBegin and AttributeEnd, as in pbrt-v4.
// CoordSysTransform knows "camera" and "world"; of other unknown names it is warned, and the transformation stays.
// Nothing moves: a shape, camera or instance whose transformations at start and end differ is an error, a light or
// texture is warned of and rests where it starts. Parameters of an Attribute are for the directives that know them, and
// their own parameters win. A directive before WorldBegin that is given twice replaces the earlier one, as in pbrt-v4,
// and is warned of. Named materials, objects and mixes may be used before they are made.
//
// Include and Import read a file, compressed if its name ends with ".gz", that is looked for in the folder of the main
// file, whichever file names it. Blocks may begin in one file and end in another that Include brings in, directives may
// not (pbrt-v4 lets them). An imported file acts on a copy of the graphics state, with coordinate systems of its own.
// Files may lie inside each other as deep as memory goes, but not inside themselves.

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
