// Material directives to materials: parameters, defaults, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.h"
#include "spectrum/named_spectra.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using testing::parse_world;
using testing::world_error_of;

/// The material of the only shape.
template <class M>
M material_of(const std::string& world) {
    const Scene scene = parse_world(world + " Shape \"sphere\"");
    return std::get<M>(scene.materials.at(static_cast<std::size_t>(scene.shapes.at(0).material)));
}

double number(const FloatParameter& parameter) { return std::get<double>(parameter); }
Spectrum constant(double value) { return ConstantSpectrum{value}; }

TEST(SceneMaterial, ConductorsAreOfCopperUnlessToldOtherwise) {
    const auto copper = material_of<ConductorMaterial>("Material \"conductor\"");
    EXPECT_EQ(std::get<ComplexIor>(copper.ior).eta, *named_spectrum("metal-Cu-eta"));
    EXPECT_EQ(std::get<ComplexIor>(copper.ior).k, *named_spectrum("metal-Cu-k"));
    EXPECT_EQ(number(copper.roughness.u), 0.0);
    EXPECT_TRUE(copper.roughness.remap);

    const auto gold = material_of<ConductorMaterial>(
        R"(Material "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" [400 2 700 4] "float roughness" 0.25
           "float vroughness" 0.5 "bool remaproughness" false)");
    EXPECT_EQ(std::get<ComplexIor>(gold.ior).eta, *named_spectrum("metal-Au-eta"));
    EXPECT_EQ(std::get<ComplexIor>(gold.ior).k, Spectrum(PiecewiseLinearSpectrum({{400, 700}, {2, 4}})));
    EXPECT_EQ(number(gold.roughness.u), 0.25);
    EXPECT_EQ(number(gold.roughness.v), 0.5);
    EXPECT_FALSE(gold.roughness.remap);

    const auto painted =
        material_of<ConductorMaterial>(R"(Material "conductor" "spectrum reflectance" [400 .5 700 .75])");
    EXPECT_EQ(std::get<Spectrum>(std::get<ReflectanceParameter>(painted.ior)),
              Spectrum(PiecewiseLinearSpectrum({{400, 700}, {0.5, 0.75}})));
}

TEST(SceneMaterial, GlassByNumberSpectrumOrName) {
    EXPECT_EQ(material_of<DielectricMaterial>("Material \"dielectric\"").eta, constant(1.5));
    EXPECT_EQ(material_of<DielectricMaterial>("Material \"dielectric\" \"float eta\" 1.25").eta, constant(1.25));
    EXPECT_EQ(material_of<DielectricMaterial>("Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"").eta,
              *named_spectrum("glass-BK7"));
    EXPECT_EQ(material_of<ThinDielectricMaterial>("Material \"thindielectric\" \"float eta\" 2").eta, constant(2.0));
}

TEST(SceneMaterial, PaperAndVarnish) {
    const auto paper = material_of<DiffuseTransmissionMaterial>("Material \"diffusetransmission\"");
    EXPECT_EQ(std::get<Spectrum>(paper.reflectance), constant(0.25));
    EXPECT_EQ(std::get<Spectrum>(paper.transmittance), constant(0.25));
    EXPECT_EQ(paper.scale, 1.0);

    const auto varnish = material_of<CoatedDiffuseMaterial>("Material \"coateddiffuse\"");
    EXPECT_EQ(std::get<Spectrum>(varnish.reflectance), constant(0.5));
    EXPECT_EQ(varnish.eta, constant(1.5));
    EXPECT_EQ(varnish.thickness, 0.01);
    EXPECT_EQ(varnish.max_depth, 10);
    const auto thick = material_of<CoatedDiffuseMaterial>(
        R"(Material "coateddiffuse" "float thickness" 2 "integer maxdepth" 40 "float g" 0.5 "integer nsamples" 4
           "spectrum albedo" [360 0 830 0])");
    EXPECT_EQ(thick.thickness, 2.0);
    EXPECT_EQ(thick.max_depth, 40);
}

const std::string kTwo =
    R"(MakeNamedMaterial "a" "string type" "diffuse" MakeNamedMaterial "b" "string type" "conductor"
)";

TEST(SceneMaterial, MixesNameTheirParts) {
    const Scene scene = parse_world(R"(Material "mix" "string materials" ["b" "a"] "float amount" 0.75 Shape "sphere"
        )" + kTwo);
    const auto& mix = std::get<MixMaterial>(scene.materials.at(static_cast<std::size_t>(scene.shapes.at(0).material)));
    EXPECT_TRUE(std::holds_alternative<ConductorMaterial>(scene.materials.at(static_cast<std::size_t>(mix.first))));
    EXPECT_TRUE(std::holds_alternative<DiffuseMaterial>(scene.materials.at(static_cast<std::size_t>(mix.second))));
    EXPECT_EQ(number(mix.amount), 0.75);
}

// Surfaces that are not there are left out, wherever their material is made; only their lights are missed.
TEST(SceneMaterial, InterfacesAreLeftOut) {
    const Scene scene =
        parse_world(R"(LightSource "point" NamedMaterial "air" Shape "sphere" Material "diffuse" Shape "sphere"
        MakeNamedMaterial "air" "string type" "interface" AttributeBegin AreaLightSource "diffuse" NamedMaterial "air"
        Shape "sphere" AttributeEnd)");
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<DiffuseMaterial>(
        scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material))));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0],
              "t.pbrt:1:1: 1 area light of material \"interface\": without a surface, they give no light");
}

TEST(SceneMaterial, NoneIsAnInterfaceAsInPbrt) {
    const Scene scene = parse_world(R"(LightSource "point"
Material "" Shape "sphere"
Material "none" "float roughness" 1 Shape "sphere"
MakeNamedMaterial "air" "string type" "none" NamedMaterial "air" Shape "sphere")");
    EXPECT_TRUE(scene.shapes.empty());
    EXPECT_THAT(scene.warnings,
                ElementsAre("t.pbrt:3:10: the material \"\" is taken as \"interface\", as in pbrt-v4",
                            "t.pbrt:4:10: the material \"none\" is taken as \"interface\", as in pbrt-v4, and its "
                            "parameters have no effect",
                            "t.pbrt:5:39: the material \"none\" is taken as \"interface\", as in pbrt-v4"));
}

TEST(SceneMaterial, RefusesWhatMakesNone) {
    struct Bad {
        std::string world, message;
    };
    const Bad cases[] = {
        {R"(Material "conductor" "spectrum eta" "metal-Au-eta" "rgb reflectance" [1 1 1])",
         "2:22: found \"eta\" beside \"reflectance\", expected either the reflectance, or eta and k"},
        {R"(Material "dielectric" "float eta" 0)",
         "2:35: found an index of refraction of 0, expected a number above 0"},
        {R"(Material "dielectric" "spectrum eta" [400 1.5 700 -1])",
         "2:51: found -1 at 700 nm, expected 0 or a number above"},
        {R"(Material "dielectric" "float roughness" -0.5)",
         "2:41: found -0.5 for parameter \"roughness\" of material \"dielectric\", expected 0 or a number above"},
        {R"(Material "dielectric" "string eta" "glass-BK7")",
         "2:23: found type \"string\" of parameter \"eta\" of material \"dielectric\", expected float, rgb, blackbody "
         "or "
         "spectrum"},
        {R"(Material "dielectric" "spectrum eta" "glass-BK8")",
         "2:38: found spectrum \"glass-BK8\", expected a known one, or a file that can be read (nearest known name: "
         "\"glass-BK7\")"},
        {R"(Material "coateddiffuse" "spectrum albedo" [360 0.5 830 0.5])",
         "2:45: found a coat with a medium that scatters, expected an albedo of 0 (others are known to pbrt-v4 and not "
         "yet supported here)"},
        {R"(Material "mix")",
         "2:10: found a mix without materials, expected a parameter \"string materials\" of two names"},
        {R"(Material "mix" "string materials" ["a"])",
         "2:16: found 1 value for parameter \"materials\" of material \"mix\", expected 2"},
        {R"(Material "mix" "string materials" ["a" "c"] )" + kTwo,
         "2:40: found unknown named material \"c\", expected one that MakeNamedMaterial makes (a, b)"},
        {R"(MakeNamedMaterial "m" "string type" "mix" "string materials" ["m" "m"])",
         "2:1: found a mix that is part of itself, expected one of other materials"},
        {R"(MakeNamedMaterial "i" "string type" "interface" Material "mix" "string materials" ["i" "i"])",
         "2:1: found the interface \"i\" as part of a mix, expected another material (known to pbrt-v4 and not yet "
         "supported here)"},
        {R"(Material "dialectric")",
         "2:10: found unknown material \"dialectric\", expected a known one (nearest known name: \"dielectric\")"},
    };
    for (const Bad& bad : cases) EXPECT_EQ(world_error_of(bad.world), "t.pbrt:" + bad.message) << bad.world;
}

}  // namespace
}  // namespace emulsion
