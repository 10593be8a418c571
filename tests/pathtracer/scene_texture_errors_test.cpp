// What the Texture directive refuses.

#include <string>

#include <gtest/gtest.h>

#include "pathtracer/scene_textures.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using testing::parse_world;
using testing::world_error_of;

struct BadTexture {
    std::string text, message;
};

TEST(SceneTextureErrors, RefusesWhatIsNoTexture) {
    const BadTexture bad[] = {
        {R"(Texture "x" "color" "constant")",
         "13: found unknown kind of texture \"color\", expected a known one (nearest known name: \"float\")"},
        {R"(Texture "x" "spectrum" "constnat")",
         "24: found unknown spectrum texture \"constnat\", expected a known one (nearest known name: \"constant\")"},
        {R"(Texture "x" "spectrum" "marble")",
         "24: found spectrum texture \"marble\", expected a supported one (known to pbrt-v4 and not yet supported "
         "here; "
         "supported: constant, scale, mix, imagemap, checkerboard)"},
        {R"(Texture "x" "float" "windy")",
         "21: found float texture \"windy\", expected a supported one (known to pbrt-v4 and not yet supported here; "
         "supported: constant, scale, mix, imagemap, checkerboard)"},
        {R"(Texture "x" "float" "checkerboard" "integer dimension" 4)",
         "56: found a checkerboard in 4 dimensions, expected 2 or 3"},
        {R"(Texture "x" "float" "checkerboard" "string mapping" "planer")",
         "53: found unknown mapping \"planer\", expected a known one (nearest known name: \"planar\")"},
        {R"(Texture "x" "float" "mix" "rgb tex1" [0 0 0])",
         "27: found type \"rgb\" of parameter \"tex1\" of float texture \"mix\", expected float or texture"},
        {R"(Texture "x" "spectrum" "mix" "float tex1" .5)",
         "30: found type \"float\" of parameter \"tex1\" of spectrum texture \"mix\", expected rgb, blackbody, "
         "spectrum "
         "or texture"},
        {R"(Texture "x" "spectrum" "constant" "rgb value" [0 2 0])", "50: found 2, expected reflectances from 0 to 1"},
        {R"(Texture "x" "spectrum" "constant" "texture value" "y")",
         "35: found type \"texture\" of parameter \"value\" of spectrum texture \"constant\", expected a supported one "
         "(known to pbrt-v4 and not yet supported here; supported: rgb, blackbody or spectrum)"},
        {R"(Texture "x" "float" "mix" "texture tex1" ["a" "b"])",
         "27: found 2 values for parameter \"tex1\" of float texture \"mix\", expected 1"},
        {R"(Texture "x" "float" "imagemap")",
         "21: found an imagemap without a file, expected a parameter \"string filename\""},
        {R"(Texture "x" "spectrum")", "23: found the end of the file, expected a string after Texture"},
        {R"(Texture "x" "float" "constant" Texture "x" "float" "constant")",
         "40: found a second float texture \"x\", expected each name only once (the first is at t.pbrt:2:9)"},
    };
    for (const BadTexture& texture : bad) {
        EXPECT_EQ(world_error_of(texture.text), "t.pbrt:2:" + texture.message) << texture.text;
    }
}

TEST(SceneTextureErrors, RefusesNamesThatStandForNoTexture) {
    const std::string textures =
        R"(Texture "bricks" "spectrum" "checkerboard" Texture "bumps" "float" "checkerboard" )";
    const auto error_of = [&](const std::string& text) {
        const std::string message = world_error_of(textures + "\n" + text);
        return message.substr(message.find(' ') + 1);
    };
    EXPECT_EQ(
        error_of(R"(Material "diffuse" "texture reflectance" "brick")"),
        "found unknown spectrum texture \"brick\", expected one that a Texture directive before it makes (nearest "
        "known name: \"bricks\")");
    EXPECT_EQ(error_of(R"(Material "diffuse" "texture reflectance" "bumps")"),
              "found the float texture \"bumps\", expected a spectrum texture");
    EXPECT_EQ(error_of(R"(Texture "x" "float" "scale" "texture tex" "bricks")"),
              "found the spectrum texture \"bricks\", expected a float texture");
    // Itself.
    EXPECT_EQ(error_of(R"(Texture "x" "float" "scale" "texture tex" "x")"),
              "found unknown float texture \"x\", expected one that a Texture directive before it makes (bumps)");
    EXPECT_EQ(
        world_error_of(R"(Material "diffuse" "texture reflectance" "t")"),
        "t.pbrt:2:42: found unknown spectrum texture \"t\", expected one that a Texture directive before it makes "
        "(none is known)");
}

TEST(SceneTextureErrors, EvaluationsStayWithinBounds) {
    // Each is a mix of the one before with itself: the n-th comes to 2^n - 1.
    std::string world = R"(Texture "t1" "float" "checkerboard" )";
    const auto doubled = [](int i) {
        const std::string before = "\"t" + std::to_string(i - 1) + "\" ";
        return "\nTexture \"t" + std::to_string(i) + "\" \"float\" \"mix\" \"texture tex1\" " + before +
               "\"texture tex2\" " + before;
    };
    for (int i = 2; i <= 8; ++i) world += doubled(i);
    EXPECT_EQ(parse_world(world).float_textures.size(), 8u);
    EXPECT_EQ(world_error_of(world + doubled(9)),
              "t.pbrt:10:22: found a texture of 511 evaluations of textures, expected at most 256");
}

}  // namespace
}  // namespace emulsion
