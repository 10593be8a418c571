#include "pathtracer/scene_departures.h"

#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> warnings_of(const std::string& world) {
    return testing::parse("Camera \"perspective\"\nWorldBegin LightSource \"infinite\"\n" + world).warnings;
}

TEST(SceneDepartures, ScaledLightsAndPartsOfThem) {
    const std::string light = "AreaLightSource \"diffuse\" ";
    EXPECT_THAT(warnings_of(light + "Scale 2 2 2 Shape \"disk\""),
                ElementsAre(HasSubstr("3:45: a scaled shape shines")));
    EXPECT_THAT(warnings_of(light + "Scale 1 1 3 Shape \"cylinder\""), ElementsAre(HasSubstr("a scaled shape")));
    EXPECT_THAT(warnings_of(light + "Shape \"disk\" \"float innerradius\" 0.5"),
                ElementsAre(HasSubstr("a part of a shape")));
    EXPECT_THAT(warnings_of(light + "Shape \"sphere\" \"float zmax\" 0.5"),
                ElementsAre(HasSubstr("a part of a shape")));

    EXPECT_THAT(
        warnings_of(light + "Rotate 30 1 2 3 Translate 1 2 3 Shape \"disk\" Shape \"sphere\" Shape \"cylinder\""),
        IsEmpty());
    EXPECT_THAT(warnings_of("Scale 2 2 2 Shape \"disk\""), IsEmpty()) << "it does not shine";
    EXPECT_THAT(warnings_of(light + "Scale 2 2 2 Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]"), IsEmpty());
}

TEST(SceneDepartures, MetalsWhoseTablesEnd) {
    const std::string metal = "Material \"conductor\" ";
    EXPECT_THAT(warnings_of(metal + "\"spectrum eta\" [400 0.2 700 0.3] \"spectrum k\" [400 3 700 4]"),
                ElementsAre(HasSubstr("eta and k end within 360 to 830 nm")));
    EXPECT_THAT(warnings_of(metal + "\"spectrum eta\" [300 0.2 900 0.3] \"spectrum k\" [300 3 900 4]"), IsEmpty());
    EXPECT_THAT(warnings_of(metal + "\"spectrum eta\" \"metal-Ag-eta\" \"spectrum k\" \"metal-Ag-k\""), IsEmpty());
}

}  // namespace
}  // namespace emulsion
