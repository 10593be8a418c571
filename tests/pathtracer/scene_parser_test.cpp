#include "pathtracer/scene_parser.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene_text.h"
#include "spectrum/colorimetry.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::error_of;
using testing::parse;

struct BadText {
    std::string text, message;
};

TEST(SceneParser, NamesTheTokenAtFault) {
    const std::string unsupported =
        "expected a supported one (known to pbrt-v4 and not yet supported here; supported: ";
    const BadText bad[] = {
        {"", "1:1: found the end of the file, expected WorldBegin"},
        {"# nothing\n", "2:1: found the end of the file, expected WorldBegin"},
        {"WorldBegin\nShpae \"sphere\"",
         "2:1: found unknown directive \"Shpae\", expected a known one (nearest known name: \"Shape\")"},
        {"worldbegin",
         "1:1: found unknown directive \"worldbegin\", expected a known one (nearest known name: "
         "\"WorldBegin\")"},
        {"WorldBegin WorldEnd",
         "1:12: found unknown directive \"WorldEnd\", expected a known one (nearest known name: \"WorldBegin\")"},
        {"\"Camera\"", "1:1: found the string \"Camera\", expected a directive"},
        {"WorldBegin ]", "1:12: found \"]\", expected a directive"},
        {"Camera", "1:7: found the end of the file, expected a string after Camera"},
        {"Camera [", "1:8: found \"[\", expected a string after Camera"},
        {"Camera \"perspektive\"",
         "1:8: found unknown camera \"perspektive\", expected a known one (nearest known name: \"perspective\")"},
        {"Camera \"realistic\"",
         "1:8: found camera \"realistic\", " + unsupported + "perspective, orthographic, spherical)"},
        {"Sampler \"haltn\"",
         "1:9: found unknown sampler \"haltn\", expected a known one (nearest known name: \"halton\")"},
        {"WorldBegin Material \"hair\"",
         "1:21: found material \"hair\", " + unsupported +
             "diffuse, conductor, dielectric, thindielectric, diffusetransmission, coateddiffuse, mix, interface)"},
        {"WorldBegin LightSource \"projection\"",
         "1:24: found light source \"projection\", " + unsupported + "point, spot, distant, infinite)"},
        {"WorldBegin Shape \"curve\"", "1:18: found shape \"curve\", " + unsupported +
                                           "trianglemesh, bilinearmesh, plymesh, sphere, disk, cylinder)"},
        {"Accelerator \"embree\"",
         "1:13: found unknown accelerator \"embree\", expected a known one (nearest known "
         "name: \"kdtree\")"},
        {"Integrator \"sppm\"",
         "1:12: found integrator \"sppm\", " + unsupported + "path, volpath, simplepath, simplevolpath, bdpt, mlt)"},
        {"WorldBegin Shape \"loopsubdiv\"",
         "1:18: found shape \"loopsubdiv\", expected a supported one (surfaces are not subdivided here: its control "
         "cage, the \"indices\" and \"P\", can be given as a \"trianglemesh\")"},
        {"MakeNamedMedium \"fog\"",
         "1:1: found directive \"MakeNamedMedium\", expected a supported one (there are no media here)"},
        {"Camera \"perspective\" \"float fow\" 3",
         "1:22: found unknown parameter \"fow\" of camera \"perspective\", expected a known one (nearest known name: "
         "\"fov\")"},
        {"Camera \"perspective\" \"float fov\" 3 \"integer fov\" 4",
         "1:36: found a second parameter \"fov\", expected each only once (the first is at t.pbrt:1:22)"},
        {"Camera \"perspective\" \"string fov\" \"3\"",
         "1:22: found type \"string\" of parameter \"fov\" of camera \"perspective\", expected float"},
        {"Camera \"perspective\" \"float fov\" [3 4]",
         "1:22: found 2 values for parameter \"fov\" of camera \"perspective\", expected 1"},
        {"Camera \"perspective\" \"float fov\" \"3\"", "1:34: found the string \"3\", expected a number"},
        {"Camera \"perspective\" \"float fov\" [3",
         "1:36: found the end of the file, expected a \"]\" for the \"[\" at t.pbrt:1:34"},
        {"Camera \"perspective\" \"float fov\" [3\nWorldBegin",
         "2:1: found \"WorldBegin\", expected a number or \"]\""},
        {"Camera \"perspective\" \"float fov\" [[3]]", "1:35: found \"[\", expected a number or \"]\""},
        {"Camera \"perspective\" \"float fov\"", "1:33: found the end of the file, expected a number"},
        {"Camera \"perspective\" \"flaot fov\" 3",
         "1:22: found unknown parameter type \"flaot\", expected a known one (nearest known name: \"float\")"},
        {"Camera \"perspective\" \"fov\" 3", "1:22: found the string \"fov\", expected a parameter's \"type name\""},
        {"Camera \"perspective\" \"float fov x\" 3",
         "1:22: found the string \"float fov x\", expected a parameter's \"type name\""},
        {"Camera \"perspective\" \" \" 3", "1:22: found the string \" \", expected a parameter's \"type name\""},
        {"Film \"rgb\" \"string filename\" out.exr", "1:30: found \"out.exr\", expected a string"},
        {"Film \"rgb\" \"bool savefp16\" [true maybe]", "1:34: found \"maybe\", expected true, false or \"]\""},
        {"Film \"rgb\" \"float maxcomponentvalue\" 10",
         "1:12: found parameter \"maxcomponentvalue\" of film \"rgb\", " + unsupported +
             "xresolution, yresolution, filename, savefp16, sensor, iso, diagonal, cropwindow, pixelbounds, "
             "whitebalance)"},
        {"Translate 1 2", "1:14: found the end of the file, expected a number, the 3 of 3"},
        {"Translate 1 2 x", "1:15: found \"x\", expected a number, the 3 of 3"},
        {"Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 2]", "1:44: found \"2\", expected a \"]\" after 16 numbers"},
        {"Shape \"sphere\"", "1:1: found Shape before WorldBegin, expected it after, and only there"},
        {"AttributeBegin", "1:1: found AttributeBegin before WorldBegin, expected it after, and only there"},
        {"WorldBegin Camera \"perspective\"",
         "1:12: found Camera after WorldBegin, expected it before, and only there"},
        {"WorldBegin WorldBegin", "1:12: found WorldBegin after WorldBegin, expected it before, and only there"},
        {"WorldBegin AttributeEnd",
         "1:12: found AttributeEnd without its AttributeBegin, expected as many of one as the other"},
        {"WorldBegin\nAttributeBegin\n AttributeBegin AttributeEnd",
         "2:1: found AttributeBegin without its AttributeEnd, expected as many of one as the other"},
        {"WorldBegin \xff\x01\n", R"(1:12: found unknown directive "\xff\x01", expected a known one)"},
    };
    for (const BadText& text : bad) {
        const std::string message = error_of(text.text);
        EXPECT_EQ(message, "t.pbrt:" + text.message) << text.text;
        EXPECT_EQ(message.find('\n'), std::string::npos) << text.text;
    }
}

TEST(SceneParser, TakesAWholeScene) {
    const Scene scene = parse(R"(# comment
        LookAt 0 0 -5 0 0 0 0 1 0
        Camera "perspective" "float fov" 40 Film "rgb" "integer xresolution" [ 64 ] "integer yresolution" 32
        Sampler "independent" PixelFilter "box" Integrator "path"
        WorldBegin LightSource "infinite" Material "diffuse" "rgb reflectance" [ .5 .5 .5 ]
        AttributeBegin Translate 0 1 0 Shape "sphere" AttributeEnd
        ReverseOrientation Shape "sphere")");
    EXPECT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.film.width_px, 64);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneParser, ReadsFilesOrSaysWhyNot) {
    const TemporaryFolder temporary;
    const std::filesystem::path& folder = temporary.path();
    const auto reason_of = [](const std::filesystem::path& path) -> std::string {
        try {
            static_cast<void>(read_scene(path));
        } catch (const IoError& error) {
            EXPECT_EQ(error.path(), path);
            return error.reason();
        }
        return "(no error)";
    };
    EXPECT_EQ(reason_of(folder / "there-is-no-such.pbrt"), "No such file or directory");
    EXPECT_EQ(reason_of(folder), "is a folder, not a text file");
    EXPECT_EQ(reason_of("/dev/zero"), "is no file that can be read");

    const std::filesystem::path empty = folder / "empty.pbrt";
    write_text(empty, "");
    try {
        static_cast<void>(read_scene(empty));
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_EQ(error.what(), empty.string() + ":1:1: found the end of the file, expected WorldBegin");
    }
}

TEST(SceneParser, ReadsTheCornellBox) {
    const Scene scene = read_scene(std::filesystem::path(EMULSION_SOURCE_DIR) / "scenes/cornell-box.pbrt");
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(scene.film.width_px, 512);
    EXPECT_EQ(scene.film.height_px, 512);
    EXPECT_EQ(scene.integrator.max_depth, 8);
    EXPECT_EQ(std::get<PaddedSobolSampler>(scene.sampler).samples_per_pixel, 64);
    EXPECT_EQ(scene.materials.size(), 3u);
    ASSERT_EQ(scene.shapes.size(), 8u);

    std::size_t triangles = 0;
    for (const Shape& shape : scene.shapes) triangles += std::get<TriangleMesh>(shape.geometry).triangle.size();
    EXPECT_EQ(triangles, 32u);

    const ScaledSpectrum& lamp = scene.shapes[0].area_light.value().radiance;
    EXPECT_NEAR(lamp.scale * xyz_of_radiance(lamp.spectrum).y, 10000.0, 0.01);
    EXPECT_FALSE(std::get<TriangleMesh>(scene.shapes[0].geometry).flip_normal);
}

TEST(SceneParser, NestsDeeplyWithoutHarm) {
    std::string begins, ends;
    for (int i = 0; i < 100000; ++i) {
        begins += "AttributeBegin ";
        ends += "AttributeEnd ";
    }
    const std::string light = "WorldBegin LightSource \"infinite\" AreaLightSource \"diffuse\" ";
    EXPECT_EQ(parse(light + begins + "Shape \"sphere\" " + ends).shapes.size(), 1u);
    EXPECT_EQ(error_of(light + begins + ends + ends).substr(0, 9), "t.pbrt:1:");
}

// The hash is that of contents: of the scene's text and of the files that it reads, wherever they lie.
TEST(SceneParser, HashesWhatTheSceneWasReadFrom) {
    const TemporaryFolder a, b;
    const std::string text = "WorldBegin LightSource \"infinite\" \"spectrum L\" \"lamp.spd\"\n";
    const auto hash_of = [](const TemporaryFolder& folder, const std::string& scene, const std::string& lamp) {
        write_text(folder.file("lamp.spd"), lamp);
        return parse_scene(scene, folder.file("t.pbrt")).hash;
    };
    const std::string hash = hash_of(a, text, "400 1 700 1");
    EXPECT_EQ(hash.size(), 32u);
    EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_EQ(hash_of(b, text, "400 1 700 1"), hash);
    EXPECT_NE(hash_of(a, text, "400 1 700 2"), hash);
    EXPECT_NE(hash_of(a, text + "# a comment\n", "400 1 700 1"), hash);
}

}  // namespace
}  // namespace emulsion
