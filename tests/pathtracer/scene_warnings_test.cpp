#include "pathtracer/scene_warnings.h"

#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(SceneWarnings, ShowTheFirstFewOfEachKind) {
    const SourceText text("t.pbrt", "a\nb");
    SceneWarnings warnings;
    for (std::size_t i = 0; i < SceneWarnings::kShown + 5; ++i) {
        warnings.add({&text, 2},
                     fmt::format("patch {} of \"mesh (no. {})\" is odd (like {})", i, i, std::string(i, 'x')));
    }
    warnings.add({&text, 0}, "another thing");
    const std::vector<std::string> list = warnings.list();
    ASSERT_EQ(list.size(), SceneWarnings::kShown + 1);
    EXPECT_EQ(list[0], "t.pbrt:2:1: patch 0 of \"mesh (no. 0)\" is odd (like )");
    EXPECT_EQ(list[7], "t.pbrt:2:1: patch 7 of \"mesh (no. 7)\" is odd (like xxxxxxx) (and 5 more like this)");
    EXPECT_EQ(list[8], "t.pbrt:1:1: another thing");
}

TEST(SceneWarnings, AsManyAsAreShownAreAll) {
    const SourceText text("t.pbrt", "a");
    SceneWarnings warnings;
    for (std::size_t i = 0; i < SceneWarnings::kShown; ++i) warnings.add({&text, 0}, "odd");
    EXPECT_THAT(warnings.list(), ::testing::Each("t.pbrt:1:1: odd"));
}

}  // namespace
}  // namespace emulsion
