// The values that options may have, whatever they are of.

#include <string>

#include <gtest/gtest.h>

#include "pathtracer/scene_options.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using testing::error_of;
using testing::parse_options;
using testing::perspective;

TEST(SceneOptionValues, NumbersMayBeDeclaredEitherWay) {
    EXPECT_EQ(perspective(parse_options(R"(Camera "perspective" "integer fov" 45)")).fov_deg, 45.0);
    EXPECT_EQ(parse_options(R"(Film "rgb" "float xresolution" 300.0)").film.width_px, 300);
    EXPECT_EQ(parse_options(R"(Film "rgb" "integer xresolution" 3e2)").film.width_px, 300);
    EXPECT_EQ(
        error_of(R"(Film "rgb" "float xresolution" 300.5)"),
        "t.pbrt:1:32: found 300.5 for parameter \"xresolution\" of film \"rgb\", expected a whole number of at most "
        "32 bits");
    EXPECT_EQ(error_of(R"(Film "rgb" "integer xresolution" 300.5)"),
              "t.pbrt:1:34: found \"300.5\", expected a whole number of at most 32 bits");
    EXPECT_EQ(error_of(R"(Film "rgb" "integer xresolution" 3000000000)"),
              "t.pbrt:1:34: found \"3000000000\", expected a whole number of at most 32 bits");
}

TEST(SceneOptionValues, FlagsMayBeQuoted) {
    EXPECT_EQ(parse_options(R"(Film "rgb" "bool savefp16" "true")").film.pixel_type, PixelType::half);
    EXPECT_EQ(parse_options(R"(Film "rgb" "bool savefp16" ["false"])").film.pixel_type, PixelType::float32);
    EXPECT_EQ(error_of(R"(Film "rgb" "bool savefp16" 1)"), "t.pbrt:1:28: found \"1\", expected true or false");
}

TEST(SceneOptionValues, RefusesFiltersThatCantBeNormalised) {
    // A Gaussian that is flat over the support less its value at the end is 0; lobes of a milliard outweigh their sum.
    for (const std::string filter : {R"("gaussian" "float sigma" 1e30)", R"("mitchell" "float B" 1e9)"}) {
        const std::string message = error_of("PixelFilter " + filter);
        EXPECT_EQ(message.rfind("t.pbrt:1:13: found a pixel filter that can't be normalised (", 0), 0u) << message;
    }
}

struct BadOption {
    std::string text, message;
};

TEST(SceneOptionValues, RefusesValuesOutOfRange) {
    const BadOption bad[] = {
        {R"(Camera "perspective" "float fov" 180)",
         "1:34: found a field of view of 180, expected an angle above 0 and below 180 degrees"},
        {R"(Camera "perspective" "float fov" [-1])",
         "1:35: found -1 for parameter \"fov\" of camera \"perspective\", expected a number above 0"},
        {R"(Camera "perspective" "float lensradius" -.1)",
         "1:41: found -0.1 for parameter \"lensradius\" of camera \"perspective\", expected 0 or a number above"},
        {R"(Camera "orthographic" "float fov" 40)",
         "1:23: found unknown parameter \"fov\" of camera \"orthographic\", expected a known one (frameaspectratio, "
         "screenwindow, lensradius, focaldistance, shutteropen, shutterclose)"},
        {R"(Camera "spherical" "string mapping" "equalaria")",
         "1:37: found unknown mapping \"equalaria\", expected a known one (nearest known name: \"equalarea\")"},
        {R"(Film "spectral" "integer nbuckets" 1025)",
         "1:6: found buckets of wavelengths that can't be (film: spectrum.count = 1025: must be in [1, 1024]), "
         "expected \"lambdamin\" "
         "below \"lambdamax\", and from 1 to 1024 \"nbuckets\" between them"},
        {R"(Film "spectral" "float lambdamin" 300)",
         "1:6: found wavelengths from 300 to 830 nm, expected some of those that paths have, from 360 to 830 nm"},
        {R"(Film "rgb" "integer nbuckets" 4)",
         "1:12: found unknown parameter \"nbuckets\" of film \"rgb\", expected a known one (xresolution, yresolution, "
         "filename, savefp16, sensor, iso, diagonal, cropwindow, pixelbounds, whitebalance, maxcomponentvalue)"},
        {R"(Camera "perspective" "float screenwindow" [0 1 2])",
         "1:22: found 3 values for parameter \"screenwindow\" of camera \"perspective\", expected 4"},
        {R"(Camera "perspective" "float screenwindow" [1 1 0 1])",
         "1:44: found a screen window without area, expected x min, x max, y min, y max"},
        {R"(Camera "perspective" "float shutteropen" 1)",
         "1:8: found an exposure time of 0, expected \"shutterclose\" after \"shutteropen\""},
        {R"(Film "rgb" "integer xresolution" 0)",
         "1:34: found 0 for parameter \"xresolution\" of film \"rgb\", expected a number above 0"},
        {R"(Film "rgb" "integer xresolution" 65536 "integer yresolution" 65536)",
         "1:6: found 65536 x 65536 pixels, expected at most 2147483647 in all"},
        {R"(Film "rgb" "integer xresolution" 65537)",
         "1:34: found 65537 for parameter \"xresolution\", expected at most 65536"},
        {R"(Film "rgb" "integer yresolution" 65537)",
         "1:34: found 65537 for parameter \"yresolution\", expected at most 65536"},
        {R"(Camera "perspective" "float lensradius" 1e19)",
         "1:8: found a camera that reaches 1e+19 units, each 1 long, expected coordinates from -1e15 to 1e15 in world "
         "space"},
        {R"(Camera "orthographic" "float screenwindow" [-1e19 1e19 -1 1])",
         "1:8: found a camera that reaches 1e+19 units, each 1 long, expected coordinates from -1e15 to 1e15 in world "
         "space"},
        {R"(Scale 1e-20 1e-20 1e-20 Camera "orthographic")",
         "1:32: found a camera that reaches 1 units, each 1e+20 long, expected coordinates from -1e15 to 1e15 in world "
         "space"},
        {R"(Sampler "independent" "integer pixelsamples" 16777217)",
         "1:46: found 16777217 for parameter \"pixelsamples\", expected at most 16777216"},
        {R"(Sampler "paddedsobol" "integer pixelsamples" 16777217)",
         "1:46: found 16777217 for parameter \"pixelsamples\", expected at most 16777216"},
        {R"(Scale 1e-120 1e-120 1e-120 Camera "perspective")",
         "1:35: found a camera under a transformation without inverse, expected another one"},
        {R"(Translate -1.5e15 0 2 Camera "perspective")",
         "1:30: found a camera at (1.5e+15, 0, -2), expected coordinates from -1e15 to 1e15 in world space"},
        {R"(Film "rgb" "float iso" 1e60)",
         "1:6: found an ISO speed of 1e+60, expected a number that single precision holds"},
        {R"(Film "rgb" "float iso" 1e35 WorldBegin)",
         "1:29: found a scene whose exposure time times ISO / 100 is 1e+33, expected from 1e-30 to 1e+30"},
        {R"(Film "rgb" "float whitebalance" [ 900 ])",
         "1:35: found 900 for parameter \"whitebalance\", expected a colour temperature from 1000 to 24986 K, or 0 for "
         "no white balance"},
        {R"(Film "rgb" "float whitebalance" 24987)",
         "1:33: found 24987 for parameter \"whitebalance\", expected a colour temperature from 1000 to 24986 K, or 0 "
         "for no white balance"},
        {R"(Film "rgb" "float whitebalance" -1)",
         "1:33: found -1 for parameter \"whitebalance\" of film \"rgb\", expected 0 or a number above"},
        {R"(Film "rgb" "string sensor" "nikon_d850")",
         "1:28: found sensor \"nikon_d850\", expected a supported one (known to pbrt-v4 and not yet supported here; "
         "supported: cie1931)"},
        {R"(Film "rgb" "string sensor" "cie1932")",
         "1:28: found unknown sensor \"cie1932\", expected a known one (nearest known name: \"cie1931\")"},
        {R"(Sampler "stratified" "integer xsamples" 65536 "integer ysamples" 65536)",
         "1:9: found 65536 x 65536 samples, expected at most 16777216 in all"},
        {R"(Sampler "zsobol" "string randomization" "nun")",
         "1:41: found unknown randomization \"nun\", expected a known one (nearest known name: \"none\")"},
        {R"(Sampler "pmj02bn" "string randomization" "none")",
         "1:19: found unknown parameter \"randomization\" of sampler \"pmj02bn\", expected a known one (nearest known "
         "name: \"seed\")"},
        {R"(Sampler "halton" "integer pixelsamples" 16777217)",
         "1:41: found 16777217 for parameter \"pixelsamples\", expected at most 16777216"},
        {R"(Accelerator "bwh")",
         "1:13: found unknown accelerator \"bwh\", expected a known one (nearest known name: \"bvh\")"},
        {R"(Accelerator "bvh" "string splitmethod" "sha")",
         "1:40: found unknown splitmethod \"sha\", expected a known one (nearest known name: \"sah\")"},
        {R"(PixelFilter "box" "float xradius" 1e-60)",
         "1:35: found 1e-60 for parameter \"xradius\", expected a number that single precision holds"},
        {R"(Integrator "path" "integer maxdepth" -1)",
         "1:38: found -1 for parameter \"maxdepth\" of integrator \"path\", expected 0 or a number above"},
        {R"(Integrator "path" "bool regularize" true)",
         "1:37: found true for parameter \"regularize\" of integrator \"path\", expected false (others are known to "
         "pbrt-v4 "
         "and not yet supported here)"},
    };
    for (const BadOption& option : bad) EXPECT_EQ(error_of(option.text), "t.pbrt:" + option.message) << option.text;
}

}  // namespace
}  // namespace emulsion
