#pragma once
// Scenes for the program's tests: small enough to render in an instant.

#include <string>

namespace emulsion::testing {

inline const std::string kCornellBox = EMULSION_SOURCE_DIR "/scenes/cornell-box.pbrt";

/// A floor under a lamp and a sky.
inline const std::string kSmallScene = R"(
LookAt 0 -5 3  0 0 0  0 0 1
Camera "perspective" "float fov" 40
Film "rgb" "integer xresolution" 48 "integer yresolution" 32 "string filename" "small.exr"
Sampler "independent" "integer pixelsamples" 4
WorldBegin
LightSource "infinite" "rgb L" [0.4 0.5 0.7] "float scale" 100
LightSource "point" "point3 from" [1 0 2] "blackbody I" [2800] "float scale" 500
Material "diffuse" "rgb reflectance" [0.7 0.4 0.2]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point3 P" [-9 -9 0  9 -9 0  9 9 0  -9 9 0]
Shape "sphere" "float radius" 0.7
)";

}  // namespace emulsion::testing
