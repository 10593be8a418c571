#include "core/nearest_name.h"

#include <array>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(NameDistance, CountsLettersTwiceAndCaseOnce) {
    EXPECT_EQ(name_distance("sphere", "sphere"), 0u);
    EXPECT_EQ(name_distance("Sphere", "sphere"), 1u);
    EXPECT_EQ(name_distance("spere", "sphere"), 3u);
    EXPECT_EQ(name_distance("kitten", "sitting"), 7u);
    EXPECT_EQ(name_distance("", "abc"), 7u);
}

TEST(NearestName, IsTheFirstOfTheLeastDistance) {
    constexpr std::array<std::string_view, 3> kNames = {"trianglemesh", "sphere", "Sphere"};
    EXPECT_EQ(nearest_name("sphere", kNames), "sphere");
    EXPECT_EQ(nearest_name("Spheer", kNames), "sphere");
    EXPECT_EQ(nearest_name("trianglmesh", kNames), "trianglemesh");
    EXPECT_EQ(nearest_name("qqq", kNames), "");
    EXPECT_EQ(nearest_name("sphere", {}), "");
    EXPECT_EQ(nearest_name(std::string_view("spherespherespherespherespherespherespherespherespherespherespheresphere"),
                           kNames),
              "");
}

}  // namespace
}  // namespace emulsion
