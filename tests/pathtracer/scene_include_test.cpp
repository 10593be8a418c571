// Include and Import: files inside files, compressed or not, and what hostile ones do.

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "scene_text.h"
#include "support/gzip_bytes.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using testing::gzip_bytes;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A folder with scene files in it.
class SceneInclude : public ::testing::Test {
  protected:
    void write(const std::string& name, const std::string& text) const { write_text(folder_.file(name), text); }

    [[nodiscard]] Scene read(const std::string& text) const { return parse_scene(text, folder_.file("main.pbrt")); }

    /// The message for text that is wrong, less the folder's name, or "(no error)".
    [[nodiscard]] std::string error_of(const std::string& text) const {
        std::string message = "(no error)";
        try {
            static_cast<void>(read(text));
        } catch (const SceneError& error) {
            message = error.what();
        }
        const std::string folder = folder_.path().string() + "/";
        for (auto at = message.find(folder); at != std::string::npos; at = message.find(folder)) {
            message.erase(at, folder.size());
        }
        return message;
    }

    TemporaryFolder folder_;
};

const std::string kWorld = "WorldBegin LightSource \"infinite\"\n";

std::string sphere(const std::string& radius) { return "Shape \"sphere\" \"float radius\" " + radius + "\n"; }

double radius_of(const Scene& scene, std::size_t shape) {
    return std::get<Sphere>(scene.shapes.at(shape).geometry).radius;
}

TEST_F(SceneInclude, StandsForItsText) {
    write("options.pbrt", "Film \"rgb\" \"integer xresolution\" 10\n# the end");
    write("world.pbrt", "WorldBegin LightSource \"infinite\" AttributeBegin Translate 1 0 0");
    write("shape.pbrt", sphere("2"));
    const Scene scene = read("Include \"options.pbrt\" Include \"world.pbrt\" Include \"shape.pbrt\" AttributeEnd " +
                             sphere("3") + "Include \"shape.pbrt\"");
    EXPECT_EQ(scene.film.width_px, 10);
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(radius_of(scene, 0), 2.0);
    EXPECT_EQ(std::get<Sphere>(scene.shapes[0].geometry).world_from_object.translation(), Imath::V3d(1, 0, 0));
    EXPECT_EQ(radius_of(scene, 1), 3.0);
    EXPECT_EQ(radius_of(scene, 2), 2.0);
    EXPECT_THAT(scene.warnings, IsEmpty());
    EXPECT_THAT(scene.files,
                ElementsAre(folder_.file("options.pbrt"), folder_.file("world.pbrt"), folder_.file("shape.pbrt")));
}

TEST_F(SceneInclude, NamesAreRelativeToTheMainFile) {
    std::filesystem::create_directory(folder_.file("sub"));
    write("sub/a.pbrt", "Include \"sub/b.pbrt\"");
    write("sub/b.pbrt", "Include \"c.pbrt\"");
    write("c.pbrt", sphere("2"));
    EXPECT_EQ(read(kWorld + "Include \"sub/a.pbrt\"").shapes.size(), 1u);
    EXPECT_EQ(read(kWorld + "Include \"" + folder_.file("c.pbrt") + "\"").shapes.size(), 1u);
    write("sub/wrong.pbrt", "Include \"b.pbrt\"");
    EXPECT_EQ(
        error_of(kWorld + "Include \"sub/wrong.pbrt\""),
        "sub/wrong.pbrt:1:9: found the file \"b.pbrt\" (No such file or directory), expected one that can be read");
}

TEST_F(SceneInclude, ErrorsAndWarningsNameTheFileTheyAreIn) {
    write("a.pbrt", "# one\n  Shape \"spere\"");
    EXPECT_EQ(error_of(kWorld + "Include \"a.pbrt\""),
              "a.pbrt:2:9: found unknown shape \"spere\", expected a known one (nearest known name: \"sphere\")");
    write("b.pbrt", "\nTransformBegin TransformEnd");
    EXPECT_THAT(read(kWorld + "Include \"b.pbrt\"").warnings,
                ElementsAre(HasSubstr("b.pbrt:2:1: TransformBegin is deprecated")));
    write("c.pbrt", "AttributeBegin");
    EXPECT_EQ(error_of(kWorld + "Include \"c.pbrt\""),
              "c.pbrt:1:1: found AttributeBegin without its AttributeEnd, expected as many of one as the other");
    write("d.pbrt", "NamedMaterial \"m\"");
    EXPECT_THAT(error_of(kWorld + "Include \"d.pbrt\""), HasSubstr("d.pbrt:1:15: found unknown named material \"m\""));
}

// Directives don't go on in the next file.
TEST_F(SceneInclude, AFileHoldsWholeDirectives) {
    write("half.pbrt", "Translate 1 2");
    EXPECT_EQ(error_of("Include \"half.pbrt\" 3 " + kWorld),
              "half.pbrt:1:14: found the end of the file, expected a number, the 3 of 3");
    write("open.pbrt", "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0");
    EXPECT_EQ(error_of(kWorld + "Include \"open.pbrt\" ]"),
              "open.pbrt:1:40: found the end of the file, expected a \"]\" for the \"[\" at open.pbrt:1:33");
    write("string.pbrt", "Shape \"sph");
    EXPECT_EQ(error_of(kWorld + "Include \"string.pbrt\" ere\""),
              "string.pbrt:1:7: found a string without its closing quote, expected a quote (\") before the end of the "
              "line");
    write("shape.pbrt", "Shape \"sphere\"");
    EXPECT_EQ(error_of(kWorld + "Include \"shape.pbrt\" \"float radius\" 2"),
              "main.pbrt:2:22: found the string \"float radius\", expected a directive");
}

TEST_F(SceneInclude, RefusesWhatCantBeRead) {
    const auto refused = [](const std::string& name, const std::string& why) {
        return "main.pbrt:1:9: found the file \"" + name + "\" (" + why + "), expected one that can be read";
    };
    EXPECT_EQ(error_of("Include \"none.pbrt\""), refused("none.pbrt", "No such file or directory"));
    EXPECT_EQ(error_of("Include \".\""), refused(".", "is a folder, not a text file"));
    EXPECT_EQ(error_of("Include \"/dev/zero\""), refused("/dev/zero", "is no file that can be read"));
    EXPECT_EQ(error_of("Include none.pbrt"), "main.pbrt:1:9: found \"none.pbrt\", expected a string after Include");
    EXPECT_EQ(error_of("Include"), "main.pbrt:1:8: found the end of the file, expected a string after Include");
    write("empty.pbrt", "");
    EXPECT_EQ(error_of("Include \"empty.pbrt\" Include \"empty.pbrt\" WorldBegin"), "(no error)");
}

TEST_F(SceneInclude, CyclesAreNamed) {
    write("a.pbrt", "Include \"a.pbrt\"");
    EXPECT_EQ(error_of("Include \"a.pbrt\""),
              "a.pbrt:1:9: found the file \"a.pbrt\" inside itself, expected files that don't include themselves");
    write("b.pbrt", "\n Include \"c.pbrt\"");
    write("c.pbrt", "Include \"./d.pbrt\"");
    write("d.pbrt", "Include \"x/../b.pbrt\"");
    EXPECT_EQ(
        error_of("Include \"b.pbrt\""),
        "./d.pbrt:1:9: found the file \"b.pbrt\" inside itself (through \"d.pbrt\", \"c.pbrt\"), expected files that "
        "don't include themselves");
    // The main file itself, under its own name or by a link.
    write("main.pbrt", "Include \"main.pbrt\"");
    EXPECT_THROW(static_cast<void>(read_scene(folder_.file("main.pbrt"))), SceneError);
    std::filesystem::create_symlink(folder_.file("main.pbrt"), folder_.file("link.pbrt"));
    EXPECT_EQ(
        error_of("Include \"link.pbrt\""),
        "main.pbrt:1:9: found the file \"main.pbrt\" inside itself, expected files that don't include themselves");
}

TEST_F(SceneInclude, DeepNestingCostsMemoryOnly) {
    constexpr int kDeep = 10000;
    for (int i = 0; i < kDeep; ++i) {
        write(std::to_string(i) + ".pbrt",
              "AttributeBegin Include \"" + std::to_string(i + 1) + ".pbrt\" AttributeEnd\n");
    }
    const std::string last = std::to_string(kDeep) + ".pbrt";
    write(last, sphere("2"));
    const Scene scene = read(kWorld + "Include \"0.pbrt\"");
    EXPECT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(scene.files.size(), kDeep + 1u);

    write(last, "Include \"0.pbrt\"");
    EXPECT_EQ(
        error_of(kWorld + "Include \"0.pbrt\""),
        "10000.pbrt:1:9: found the file \"0.pbrt\" inside itself (through \"10000.pbrt\", \"9999.pbrt\", "
        "\"9998.pbrt\", \"9997.pbrt\", \"9996.pbrt\" and 9995 more), expected files that don't include themselves");
    std::filesystem::remove(folder_.file(last));
    EXPECT_EQ(
        error_of(kWorld + "Include \"0.pbrt\""),
        "9999.pbrt:1:24: found the file \"10000.pbrt\" (No such file or directory), expected one that can be read");
}

// Each file includes the next one twice: 2^40 files in all, were there no limit.
TEST_F(SceneInclude, FilesThatMultiplyEnd) {
    for (int i = 0; i < 40; ++i) {
        const std::string next = "Include \"" + std::to_string(i + 1) + ".pbrt\"\n";
        write(std::to_string(i) + ".pbrt", next + next);
    }
    write("40.pbrt", "");
    EXPECT_THAT(error_of("Include \"0.pbrt\""), HasSubstr("expected a scene of at most 1000000 files"));
}

TEST_F(SceneInclude, MayBeCompressed) {
    write("shape.pbrt.gz", gzip_bytes(sphere("2") + "# comment\n" + sphere("3")));
    const Scene scene = read(kWorld + "Include \"shape.pbrt.gz\"");
    EXPECT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.files.size(), 1u);

    write("wrong.pbrt.gz", gzip_bytes("\nShape \"spere\""));
    EXPECT_THAT(error_of(kWorld + "Include \"wrong.pbrt.gz\""), HasSubstr("wrong.pbrt.gz:2:7: found unknown shape"));
    const std::string whole = gzip_bytes(sphere("2"));
    write("cut.pbrt.gz", whole.substr(0, whole.size() - 9));
    EXPECT_EQ(error_of(kWorld + "Include \"cut.pbrt.gz\""),
              "main.pbrt:2:9: found the file \"cut.pbrt.gz\" (is cut off: its gzip data has no end), expected one that "
              "can be read");
    write("plain.pbrt.gz", sphere("2"));
    EXPECT_EQ(error_of(kWorld + "Import \"plain.pbrt.gz\""),
              "main.pbrt:2:8: found the file \"plain.pbrt.gz\" (is damaged, or no gzip file), expected one that can be "
              "read");
    // Spectra, too.
    write("lamp.spd.gz", gzip_bytes("400 1 700 1"));
    EXPECT_EQ(read("WorldBegin LightSource \"infinite\" \"spectrum L\" \"lamp.spd.gz\"").lights.size(), 1u);
}

TEST_F(SceneInclude, ContentsCountForTheHash) {
    const std::string text = kWorld + "Include \"a.pbrt\"";
    write("a.pbrt", sphere("2"));
    const std::string hash = read(text).hash;
    EXPECT_EQ(read(text).hash, hash);
    write("a.pbrt", sphere("3"));
    EXPECT_NE(read(text).hash, hash);
}

// --- Import

TEST_F(SceneInclude, ImportsActOnACopyOfTheState) {
    write("a.pbrt", R"(Translate 0 1 0 Material "diffuse" "blackbody reflectance" 9 ReverseOrientation
        Attribute "shape" "float radius" 7 MakeNamedMaterial "m" "string type" "diffuse"
        Shape "sphere" ObjectBegin "o" ObjectEnd)");
    const Scene scene = read(kWorld +
                             "Translate 1 0 0 Import \"a.pbrt\" Shape \"sphere\" ObjectInstance \"o\" "
                             "NamedMaterial \"m\" Shape \"sphere\"");
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(std::get<Sphere>(scene.shapes[0].geometry).world_from_object.translation(), Imath::V3d(1, 1, 0));
    EXPECT_EQ(radius_of(scene, 0), 7.0);
    const auto& after = std::get<Sphere>(scene.shapes[1].geometry);
    EXPECT_EQ(after.world_from_object.translation(), Imath::V3d(1, 0, 0));
    EXPECT_EQ(after.radius, 1.0);
    EXPECT_FALSE(after.flip_normal);
    EXPECT_NE(scene.shapes[0].material, scene.shapes[1].material);
    EXPECT_EQ(scene.instances.size(), 1u);
    EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(SceneInclude, ImportsMayStandInObjects) {
    write("a.pbrt", "Shape \"sphere\"");
    const Scene scene = read(kWorld + "ObjectBegin \"o\" Import \"a.pbrt\" Shape \"sphere\" ObjectEnd");
    EXPECT_EQ(scene.objects.at(0).shapes.size(), 2u);
    EXPECT_TRUE(scene.shapes.empty());
}

TEST_F(SceneInclude, BlocksDontCrossAnImport) {
    write("open.pbrt", "AttributeBegin");
    EXPECT_EQ(error_of(kWorld + "Import \"open.pbrt\" AttributeEnd"),
              "open.pbrt:1:1: found AttributeBegin without its AttributeEnd, expected as many of one as the other");
    write("close.pbrt", "AttributeEnd");
    EXPECT_EQ(error_of(kWorld + "AttributeBegin Import \"close.pbrt\""),
              "close.pbrt:1:1: found AttributeEnd without its AttributeBegin, expected as many of one as the other");
    write("end.pbrt", "ObjectEnd");
    EXPECT_EQ(error_of(kWorld + "ObjectBegin \"o\" Import \"end.pbrt\""),
              "end.pbrt:1:1: found ObjectEnd without its ObjectBegin, expected as many of one as the other");
    write("named.pbrt", "MakeNamedMaterial \"m\" \"string type\" \"diffuse\"");
    EXPECT_THAT(error_of(kWorld + "Import \"named.pbrt\" Import \"named.pbrt\""),
                HasSubstr("named.pbrt:1:1: found a second material \"m\""));
    EXPECT_EQ(error_of("Import \"named.pbrt\" " + kWorld),
              "main.pbrt:1:1: found Import before WorldBegin, expected it after, and only there");
}

// As in pbrt-v4, where an import neither knows nor gives names of coordinate systems.
TEST_F(SceneInclude, ImportsHaveCoordinateSystemsOfTheirOwn) {
    write("a.pbrt", "CoordSysTransform \"outside\" Shape \"sphere\" CoordinateSystem \"inside\"");
    const Scene scene = read(kWorld +
                             "Translate 1 0 0 CoordinateSystem \"outside\" Translate 1 0 0 Import \"a.pbrt\" "
                             "CoordSysTransform \"inside\" CoordSysTransform \"outside\" Shape \"sphere\"");
    EXPECT_EQ(std::get<Sphere>(scene.shapes[0].geometry).world_from_object.translation(), Imath::V3d(2, 0, 0));
    EXPECT_EQ(std::get<Sphere>(scene.shapes[1].geometry).world_from_object.translation(), Imath::V3d(1, 0, 0));
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("unknown coordinate system \"outside\""),
                                            HasSubstr("unknown coordinate system \"inside\"")));
}

}  // namespace
}  // namespace emulsion
