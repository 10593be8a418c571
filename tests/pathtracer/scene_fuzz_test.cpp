// Scenes with random damage: whatever comes out is a scene or an error of ours, never a crash or a hang. Seeds are
// fixed.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "pathtracer/scene_warnings.h"
#include "scene_text.h"

namespace emulsion {
namespace {

constexpr std::array<std::string_view, 3> kSeeds = {
    R"(# options
Scale -1 1 1 LookAt 1 2 3 0 0 0 0 1 0 Rotate 30 1 0 0
Camera "perspective" "float fov" 39.5 "float screenwindow" [ -1 1 -1 1 ] "float shutterclose" .5
Film "rgb" "integer xresolution" 64 "integer yresolution" [ 32 ] "string filename" "a\"b.exr" "bool savefp16" false
Sampler "stratified" "integer xsamples" 2 "bool jitter" "true" PixelFilter "mitchell" "float B" .3
Integrator "path" "integer maxdepth" 5 "string lightsampler" "bvh"
WorldBegin
LightSource "point" "blackbody I" 3000 "float power" 100 "point3 from" [ 0 1 2 ]
Shape "sphere" "float radius" 2
)",
    R"(WorldBegin
LightSource "distant" "spectrum L" "stdillum-A" "point3 to" [ 1 1 1 ] LightSource "infinite" "float illuminance" 3
MakeNamedMaterial "a" "string type" "diffuse" "spectrum reflectance" [ 400 .1 500 .5 700 1 ]
AttributeBegin
  AreaLightSource "diffuse" "spectrum L" [ 400 0 500 8 700 18.4 ] "float power" 15 "bool twosided" true
  Translate 1 2 3 NamedMaterial "a" ReverseOrientation
  Shape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 ] "point3 P" [ 0 0 0 1 0 0 1 1 0 0 1 0 ]
    "normal N" [ 0 0 1 0 0 1 0 0 1 0 0 1 ] "point2 uv" [ 0 0 1 0 1 1 0 1 ]
  Scale 2 .5 2 Shape "sphere" "float radius" .5
AttributeEnd
ConcatTransform [ 0 1 0 0 -1 0 0 0 0 0 1 0 10 20 30 1 ] Material "diffuse"
Shape "bilinearmesh" "point3 P" [ 0 0 0 1 0 0 0 1 0 1 1 0 ]
)",
    R"(Option "disablepixeljitter" true Option "integer seed" [ 7 ] ColorSpace "rec2020" Accelerator "bvh"
TransformTimes 0 1 Translate 0 0 -5 Camera "orthographic" "float lensradius" .1 "float focaldistance" 4
Film "spectral" "integer nbuckets" 8 "float lambdamin" 400 Sampler "halton" "string randomization" "owen"
Integrator "volpath" MediumInterface "" CoordinateSystem "before" ActiveTransform All
WorldBegin LightSource "infinite" "rgb L" [ 1 .5 .25 ] Attribute "shape" "float radius" 2
ObjectBegin "ball" TransformBegin Scale 2 2 2 Shape "sphere" "float alpha" 1 TransformEnd Material "interface"
  Shape "sphere" ObjectEnd
AttributeBegin CoordSysTransform "camera" ObjectInstance "ball" Attribute "material" "rgb reflectance" [ .1 .2 .3 ]
  Material "diffuse" ColorSpace "aces2065-1" Material "diffuse" Shape "sphere" ActiveTransform StartTime
AttributeEnd CoordSysTransform "before" ObjectInstance "ball" MediumInterface "" ""
)"};

constexpr std::array<std::string_view, 30> kTokens = {" nan ",
                                                      " 1e400 ",
                                                      " -1 ",
                                                      " 0 ",
                                                      " 1e300 ",
                                                      " 1e-300 ",
                                                      " 4294967296 ",
                                                      " \"",
                                                      " [ ",
                                                      " ] ",
                                                      " # ",
                                                      "\\",
                                                      " \"float x\" 1 ",
                                                      " true ",
                                                      " Shape ",
                                                      " WorldBegin ",
                                                      " AttributeEnd ",
                                                      " AttributeBegin ",
                                                      " ObjectBegin \"o\" ",
                                                      " ObjectEnd ",
                                                      " TransformEnd ",
                                                      " Include \"/dev/null\" ",
                                                      " Import \".\" ",
                                                      " ActiveTransform EndTime ",
                                                      " \"rgb L\" [ 1 0 2 ] ",
                                                      " Scale 0 1 1 ",
                                                      "\n",
                                                      "\r",
                                                      std::string_view("\0", 1),
                                                      "\xff\xfe"};

std::size_t below(Pcg32& random, std::size_t end) { return random.next() % end; }

/// One random edit.
void mutate(std::string& text, Pcg32& random) {
    const std::size_t at = below(random, text.size() + 1);
    const std::size_t length = std::min(below(random, 12), text.size() - at);
    switch (below(random, 6)) {
        case 0:
            text.erase(at, length);
            break;
        case 1:
            text.insert(at, kTokens.at(below(random, kTokens.size())));
            break;
        case 2:
            if (at < text.size()) text[at] = static_cast<char>(random.next());
            break;
        case 3:
            text.insert(at, text.substr(at, length));
            break;
        case 4:
            text.replace(at, length, kTokens.at(below(random, kTokens.size())));
            break;
        default:
            if (random.next() % 8 == 0) text.resize(at);
    }
}

bool is_finite(const Imath::V3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// What every scene keeps, however odd its text.
void expect_sane(const Scene& scene, const std::string& text) {
    for (const Shape& shape : scene.shapes) {
        ASSERT_LT(static_cast<std::size_t>(shape.material), scene.materials.size()) << text;
        const auto* const mesh = std::get_if<TriangleMesh>(&shape.geometry);
        if (mesh == nullptr) continue;
        ASSERT_TRUE(std::all_of(mesh->position.begin(), mesh->position.end(), is_finite)) << text;
        ASSERT_TRUE(mesh->normal.empty() || mesh->normal.size() == mesh->position.size()) << text;
        for (const auto& triangle : mesh->triangle) {
            for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh->position.size()) << text;
        }
    }
    for (const ObjectDefinition& object : scene.objects) {
        for (const Shape& shape : object.shapes) {
            ASSERT_LT(static_cast<std::size_t>(shape.material), scene.materials.size()) << text;
            ASSERT_FALSE(shape.area_light) << text;
        }
    }
    for (const ObjectInstance& instance : scene.instances) {
        ASSERT_LT(static_cast<std::size_t>(instance.object), scene.objects.size()) << text;
    }
    ASSERT_TRUE(imaging_ratio(scene.film.sensor) >= kMinImagingRatio &&
                imaging_ratio(scene.film.sensor) <= kMaxImagingRatio)
        << text;
}

enum class Outcome { scene, error };

Outcome outcome_of(const std::string& text) {
    try {
        expect_sane(testing::parse(text), text);
        return Outcome::scene;
    } catch (const SceneError& error) {
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << text;
    } catch (const IoError&) {
    }
    return Outcome::error;
}

TEST(SceneFuzz, DamagedScenesGiveScenesOrErrors) {
    constexpr int kRounds = 20000;
    Pcg32 random(20260101);
    int errors = 0;
    for (int round = 0; round < kRounds; ++round) {
        std::string text(kSeeds.at(below(random, kSeeds.size())));
        const std::size_t edits = below(random, 4);
        for (std::size_t i = 0; i <= edits; ++i) mutate(text, random);
        errors += outcome_of(text) == Outcome::error ? 1 : 0;
        ASSERT_FALSE(HasFatalFailure());
    }
    // Edits in comments and digits are harmless: were all or none refused, the test would test little.
    EXPECT_GT(errors, kRounds / 2);
    EXPECT_LT(errors, kRounds - kRounds / 50);
}

TEST(SceneFuzz, SeedsAreRight) {
    for (const std::string_view seed : kSeeds) EXPECT_EQ(testing::error_of(seed), "(no error)");
}

TEST(SceneFuzz, EveryTruncationInsideABlockIsAnError) {
    const std::string text(kSeeds[1]);
    const std::size_t begin = text.find("AttributeBegin"), end = text.find("AttributeEnd");
    ASSERT_LT(begin, end);
    for (std::size_t length = begin + 1; length < end + std::string_view("AttributeEnd").size(); ++length) {
        EXPECT_EQ(outcome_of(text.substr(0, length)), Outcome::error) << length;
    }
}

TEST(SceneFuzz, RandomBytes) {
    Pcg32 random(1);
    std::string bytes(10 << 20, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random.next());
    EXPECT_EQ(outcome_of(bytes), Outcome::error);
    EXPECT_EQ(outcome_of("WorldBegin " + bytes), Outcome::error);
    EXPECT_EQ(outcome_of("WorldBegin Shape \"" + bytes), Outcome::error);
    EXPECT_EQ(outcome_of("# " + bytes), Outcome::error);
}

/// `item` again and again, "@" replaced by its number.
std::string repeated(const std::string& item, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        for (const char c : item) text += c == '@' ? std::to_string(i) : std::string(1, c);
    }
    return text;
}

TEST(SceneFuzz, ManyOfAKindTakeNoLongerEach) {
    // Seconds in all; minutes, were any of these quadratic.
    constexpr int kMany = 100000;
    const std::string flat = "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 1 1 2 2 2]\n";
    const std::size_t few = SceneWarnings::kShown;
    EXPECT_EQ(testing::parse_world(repeated(flat, kMany)).warnings.size(), few + 1);
    const Scene films = testing::parse(repeated("Film \"rgb\" ", kMany) + "WorldBegin");
    ASSERT_EQ(films.warnings.size(), few + 1);
    EXPECT_THAT(films.warnings[few - 1], ::testing::EndsWith(fmt::format(" (and {} more like this)", kMany - 1 - few)));
    EXPECT_EQ(outcome_of("Camera \"perspective\" " + repeated("\"float p@\" 1 ", kMany)), Outcome::error);
    EXPECT_EQ(outcome_of("WorldBegin " + repeated("NamedMaterial \"m@\" ", kMany)), Outcome::error);
    // Each of them adds to those that the ones before it gave, which blocks hold on to.
    EXPECT_EQ(outcome_of("WorldBegin " + repeated("Attribute \"shape\" \"float a@\" 1 ", kMany) +
                         repeated("AttributeBegin Attribute \"shape\" \"float radius\" 1 Shape \"sphere\" ", kMany) +
                         repeated("AttributeEnd ", kMany)),
              Outcome::scene);
    EXPECT_EQ(testing::parse_world(repeated("ObjectBegin \"o@\" ObjectEnd ObjectInstance \"o@\" ", kMany / 10))
                  .instances.size(),
              std::size_t{kMany / 10});
    EXPECT_EQ(testing::parse_world(repeated("CoordinateSystem \"c@\" ", kMany)).shapes.size(), 0u);
    const std::string make = "MakeNamedMaterial \"m@\" \"string type\" \"diffuse\" ";
    EXPECT_EQ(outcome_of("WorldBegin NamedMaterial \"x\" " + repeated(make, kMany)), Outcome::error);
    EXPECT_EQ(testing::parse_world(repeated("LightSource \"point\" ", kMany)).lights.size(), std::size_t{kMany});
}

TEST(SceneFuzz, HugeTokens) {
    const std::string letters(10 << 20, 'x'), digits(10 << 20, '1'), brackets(10 << 20, '[');
    EXPECT_EQ(outcome_of(letters), Outcome::error);
    EXPECT_EQ(outcome_of("Translate 0 0 " + digits), Outcome::error);
    EXPECT_EQ(outcome_of("Camera \"perspective\" \"float fov\" " + brackets), Outcome::error);
    EXPECT_EQ(outcome_of("Camera \"" + letters + "\""), Outcome::error);
    EXPECT_EQ(outcome_of("WorldBegin Shape \"sphere\" \"float " + letters + "\" 1"), Outcome::error);
}

}  // namespace
}  // namespace emulsion
