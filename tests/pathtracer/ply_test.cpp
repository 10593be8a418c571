// Mesh files: what each format says, and what damaged ones are told.

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "pathtracer/scene_ply.h"
#include "pathtracer/surface.h"
#include "scene_text.h"
#include "support/gzip_bytes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Triangle = std::array<std::uint32_t, 3>;
using Patch = std::array<std::uint32_t, 4>;

const std::string kHeader = R"(comment made by hand
obj_info nothing
element vertex 5
property float x
property double y
property uchar flag
property float z
property float nx
property float ny
property float nz
property list uchar short more
property float s
property float t
element edge 1
property int v
element face 3
property list uchar int vertex_indices
property float area
end_header
)";

/// Writes values one by one, in text or in binary.
class Writer {
  public:
    Writer(std::string format, bool swap) : format_(std::move(format)), swap_(swap) {
        bytes_ = "ply\nformat " + format_ + " 1.0\n" + kHeader;
    }
    template <class T>
    Writer& put(T value) {
        if (format_ == "ascii") {
            bytes_ += std::to_string(value) + "\n";
            return *this;
        }
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        if (swap_) std::reverse(raw, raw + sizeof(T));
        bytes_.append(raw, sizeof(T));
        return *this;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

  private:
    std::string format_, bytes_;
    bool swap_;
};

std::string written(const std::string& format) {
    const bool native_little = std::endian::native == std::endian::little;
    Writer out(format, (format == "binary_big_endian") == native_little);
    for (int i = 0; i < 5; ++i) {
        const auto f = static_cast<float>(i);
        out.put(f).put(2.0 * i).put(static_cast<std::uint8_t>(i)).put(-f);    // x y flag z
        out.put(0.0f).put(0.5f).put(f);                                       // normal
        out.put(std::uint8_t{2}).put(std::int16_t{7}).put(std::int16_t{-7});  // a list of two
        out.put(0.25f * f).put(-0.25f * f);                                   // s t
    }
    out.put(1);  // the edge
    out.put(std::uint8_t{3}).put(0).put(1).put(2).put(0.5f);
    out.put(std::uint8_t{4}).put(1).put(2).put(3).put(4).put(0.5f);
    out.put(std::uint8_t{5}).put(0).put(1).put(2).put(3).put(4).put(0.5f);
    return out.bytes();
}

class Ply : public ::testing::TestWithParam<std::string> {};

TEST_P(Ply, IsReadInEveryFormat) {
    const PlyMesh mesh = read_ply("m.ply", written(GetParam()));
    ASSERT_EQ(mesh.position.size(), 5u);
    EXPECT_EQ(mesh.position[3], Imath::V3f(3, 6, -3));
    ASSERT_EQ(mesh.normal.size(), 5u);
    EXPECT_EQ(mesh.normal[3], Imath::V3f(0, 0.5f, 3));
    ASSERT_EQ(mesh.uv.size(), 5u);
    EXPECT_EQ(mesh.uv[3], Imath::V2f(0.75f, -0.75f));
    EXPECT_THAT(mesh.triangle, ElementsAre(Triangle{0, 1, 2}));
    EXPECT_THAT(mesh.patch, ElementsAre(Patch{1, 2, 4, 3}));  // a walk round becomes rows
    EXPECT_EQ(mesh.other_faces, 1u);
}

TEST_P(Ply, EveryTruncationIsAnError) {
    const std::string whole = written(GetParam());
    // The last number of a text may be cut and still be one.
    const std::size_t last = GetParam() == "ascii" ? whole.rfind('\n', whole.size() - 2) + 1 : whole.size();
    for (std::size_t size = 0; size < last; ++size) {
        EXPECT_THROW(static_cast<void>(read_ply("m.ply", whole.substr(0, size))), IoError) << size;
    }
}

/// Whatever comes out is a mesh with indices that have vertices, or an error.
TEST_P(Ply, DamageIsAnErrorOrAMesh) {
    Pcg32 random(11);
    const std::string whole = written(GetParam());
    for (int i = 0; i < 5000; ++i) {
        std::string damaged = whole;
        for (int k = 0; k < 3; ++k) {
            const auto place = static_cast<std::size_t>(random.next_float() * static_cast<float>(damaged.size()));
            damaged[std::min(place, damaged.size() - 1)] = static_cast<char>(random.next_float() * 256.0f);
        }
        try {
            const PlyMesh mesh = read_ply("m.ply", damaged);
            for (const Triangle& t : mesh.triangle) EXPECT_LT(std::max({t[0], t[1], t[2]}), mesh.position.size());
            for (const Patch& p : mesh.patch) EXPECT_LT(std::max({p[0], p[1], p[2], p[3]}), mesh.position.size());
        } catch (const IoError&) {
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Ply, ::testing::Values("ascii", "binary_little_endian", "binary_big_endian"),
                         [](const auto& one) { return one.param; });

std::string ply_error_of(const std::string& text) {
    try {
        static_cast<void>(read_ply("m.ply", text));
    } catch (const IoError& error) {
        return error.reason();
    }
    return "(no error)";
}

/// A triangle in text, the numbers of which stand from line 9 on.
std::string small(const std::string& body, const std::string& vertices = "3", const std::string& faces = "1") {
    return "ply\nformat ascii 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\n" + "element face " + faces +
           "\nproperty list uchar int vertex_index\nend_header\n" + body;
}

TEST(PlyErrors, NameTheLineOrTheByte) {
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 0 0\n0 1 0\n3 0 1 2")), "(no error)");
    EXPECT_EQ(ply_error_of(small("0 0 0 +1 0 1e-400 0 1 0 3 0 1 2")), "(no error)");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")),
              "line 13: found the index 3 in face 0, expected one from 0 to 2");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n")),
              "line 13: found the index -1 in face 0, expected one from 0 to 2");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n")),
              "line 13: found the index 1.5 in face 0, expected one from 0 to 2");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n")),
              "line 11: found nan for y of vertex 1, expected a number that single precision holds");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 1e39 0\n0 1 0\n3 0 1 2\n")),
              "line 11: found 1e+39 for y of vertex 1, expected a number that single precision holds");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 1e400 0\n0 1 0\n3 0 1 2\n")),
              "line 11: found inf for y of vertex 1, expected a number that single precision holds");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 a 0\n0 1 0\n3 0 1 2\n")), "line 11: found \"a\", expected a number");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n")),
              "line 13: found a list of -3 values, expected a whole number from 0 to 4294967295");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n")),
              "line 14: found the end of the file, expected another number");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 0 0\n0 1 0\n", "1000000000000")),
              "1000000000000 vertices, expected at most 4294967295");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 0 0\n0 1 0\n", "1000000000")),
              "found 18 bytes of 1000000000 announced \"vertex\" elements, expected at least 6 bytes each");
    EXPECT_EQ(ply_error_of(small("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "3", "1000000000000000000")),
              "found 9 bytes of 1000000000000000000 announced \"face\" elements, expected at least 2 bytes each");
    std::string binary = small("", "1");
    binary.replace(binary.find("ascii"), 5, "binary_little_endian");
    EXPECT_EQ(
        ply_error_of(binary + std::string(12, '\0') + '\3'),
        "byte " + std::to_string(binary.size() + 13) + ": found the end of the file after 0 bytes, expected 4 more");
}

TEST(PlyErrors, Headers) {
    EXPECT_EQ(ply_error_of(""), "line 1: found \"\", expected \"ply\"");
    EXPECT_EQ(ply_error_of("plx\n"), "line 1: found \"plx\", expected \"ply\"");
    EXPECT_THAT(ply_error_of("ply"), HasSubstr("line 2: found the end of the file"));
    EXPECT_THAT(ply_error_of("ply\n" + std::string(100000, ' ')), HasSubstr("line 2: found the end of the file"));
    EXPECT_EQ(ply_error_of("ply\nformat ascii 2.0\n"), "line 2: found version \"2.0\", expected 1.0");
    EXPECT_EQ(ply_error_of("ply\nformat text 1.0\n"),
              "line 2: found the format \"text\", expected ascii, binary_little_endian or binary_big_endian");
    EXPECT_EQ(ply_error_of("ply\nend_header\n"), "line 2: found the end of the header, expected a format before it");
    EXPECT_EQ(ply_error_of("ply\nformat ascii 1.0\nelement vertex -1\n"),
              "line 3: found \"-1\" as the number of \"vertex\", expected a whole number");
    EXPECT_EQ(ply_error_of("ply\nformat ascii 1.0\nproperty float x\n"),
              "line 3: found \"property\", expected format, comment, element, property (of an element) or end_header");
    EXPECT_EQ(ply_error_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n"),
              "line 4: found the type \"half\", expected char, uchar, short, ushort, int, uint, float or double");
    EXPECT_EQ(ply_error_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\n"),
              "line 4: found lists counted by fractions, expected a count of a whole type");
    EXPECT_EQ(ply_error_of("ply\nformat ascii 1.0\nelement vertex 1\nend_header\n"),
              "no element \"face\" in its header");
    EXPECT_EQ(ply_error_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement face 1\nend_header\n0"),
              "line 1: found vertices without x, y and z, expected these properties");
    // Old Macintosh and Windows lines.
    EXPECT_EQ(ply_error_of("ply\r\nformat ascii 1.0\r\nelement vertex 0\r\nproperty float x\r\nproperty float y\r\n"
                           "property float z\r\nelement face 0\r\nproperty list uchar int vertex_indices\r\n"
                           "end_header\r\n"),
              "(no error)");
}

TEST(PlyMeshShape, MakesTrianglesAndPatchesInWorldSpace) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "m.ply", std::ios::binary) << written("binary_little_endian");
    std::ofstream(folder.path() / "m.ply.gz", std::ios::binary) << testing::gzip_bytes(written("ascii"));
    for (const char* const name : {"m.ply", "m.ply.gz"}) {
        const Scene scene = parse_scene(std::string("WorldBegin LightSource \"infinite\" Translate 10 0 0 Scale 1 2 1\n"
                                                    "Shape \"plymesh\" \"string filename\" \"") +
                                            name + "\"",
                                        folder.path() / "t.pbrt");
        ASSERT_EQ(scene.shapes.size(), 0u) << "all in one line";
        EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr(".ply"), HasSubstr("patches without area, left out: 1 of 1"),
                                                HasSubstr("triangles without area, left out: 1 of 1")));
    }
}

TEST(PlyMeshShape, HasNormalsAndReports) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "m.ply")
        << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
           "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 nan 0 1\n0 1 0 0 0 1\n"
           "3 0 1 2\n4 0 1 2 3\n";
    const Scene scene = parse_scene(
        "WorldBegin LightSource \"infinite\" Translate 10 0 0 ReverseOrientation\n"
        "Shape \"plymesh\" \"string filename\" \"m.ply\"",
        folder.path() / "t.pbrt");
    ASSERT_EQ(scene.shapes.size(), 2u);
    const auto& patches = std::get<BilinearMesh>(scene.shapes[0].geometry);
    const auto& triangles = std::get<TriangleMesh>(scene.shapes[1].geometry);
    EXPECT_TRUE(patches.flat);
    EXPECT_THAT(patches.patch, ElementsAre(Patch{0, 1, 3, 2}));
    EXPECT_THAT(triangles.triangle, ElementsAre(Triangle{0, 1, 2}));
    EXPECT_EQ(triangles.position.at(2), Imath::V3f(11, 1, 0));
    EXPECT_EQ(triangles.normal.at(1), Imath::V3f(0, 0, -1));
    EXPECT_EQ(triangles.normal.at(2), Imath::V3f(0, 0, 0));
    EXPECT_THAT(scene.warnings,
                ElementsAre(HasSubstr("t.pbrt:2:35: \"m.ply\" has normals that are no numbers, taken as "
                                      "unknown: 1")));
    EXPECT_THAT(scene.files, ElementsAre(folder.path() / "m.ply"));
    EXPECT_FALSE(scene.hash.empty());
}

TEST(PlyMeshShape, ErrorsNameTheSceneToo) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "m.ply") << small("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
    const auto error = [&](const std::string& name) {
        try {
            static_cast<void>(parse_scene("WorldBegin\nShape \"plymesh\" \"string filename\" \"" + name + "\"",
                                          folder.path() / "t.pbrt"));
        } catch (const SceneError& e) {
            return std::string(e.what());
        }
        return std::string("(no error)");
    };
    EXPECT_THAT(error("m.ply"),
                HasSubstr("t.pbrt:2:35: found the file \"m.ply\" (line 13: found the index 3 in face 0, "
                          "expected one from 0 to 2), expected a PLY file that can be read"));
    EXPECT_THAT(error("none.ply"), HasSubstr("t.pbrt:2:35: found the file \"none.ply\" (No such file or directory)"));
}

}  // namespace
}  // namespace emulsion::testing
