#include "cli/file_names.h"

#include <gtest/gtest.h>

namespace emulsion::cli {
namespace {

TEST(FileNames, AFilmStateIsKnownByItsEndingInAnyLetters) {
    for (const char* name : {"a.film.exr", "A.FILM.EXR", "folder/a.Film.exr", "a.b.film.EXR"}) {
        EXPECT_TRUE(is_state_name(name)) << name;
        EXPECT_EQ(state_name(name), name);
    }
    for (const char* name : {"a.exr", "film.exr", "A.FILM.PNG", "a.film.exr.exr", "a.film.exr/b.exr", ""}) {
        EXPECT_FALSE(is_state_name(name)) << name;
    }
}

TEST(FileNames, TheStateBesideAPicture) {
    EXPECT_EQ(state_name("folder/a.exr"), "folder/a.film.exr");
    EXPECT_EQ(state_name("A.EXR"), "A.film.exr");
}

TEST(FileNames, AnExtensionIsTheLastOneInAnyLetters) {
    for (const char* name : {"a.exr", "A.EXR", "a.Exr", "a.png.exr"}) EXPECT_TRUE(has_extension(name, ".exr")) << name;
    for (const char* name : {"a.exr.png", "aexr", ".exr", "a.exr/b", ""}) {
        EXPECT_FALSE(has_extension(name, ".exr")) << name;
    }
}

}  // namespace
}  // namespace emulsion::cli
