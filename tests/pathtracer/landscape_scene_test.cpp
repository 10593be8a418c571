#include "pathtracer/landscape_scene.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <variant>

#include <gmock/gmock.h>

namespace emulsion {
namespace {

TEST(LandscapeScene, HasAsManyTrianglesAsAskedForAndHardlyMore) {
    for (const std::int64_t wanted : {1, 2, 3, 1000, 100'000, 123'456}) {
        const Scene scene = landscape_scene(wanted, 8);
        const auto& mesh = std::get<TriangleMesh>(scene.shapes.at(0).geometry);
        const auto count = static_cast<std::int64_t>(mesh.triangle.size());
        EXPECT_GE(count, wanted);
        if (wanted >= 100'000) {
            EXPECT_LT(static_cast<double>(count), 1.01 * static_cast<double>(wanted));
        }
        for (const auto& triangle : mesh.triangle) {
            for (const std::uint32_t corner : triangle) ASSERT_LT(std::size_t{corner}, mesh.position.size());
        }
        EXPECT_EQ(scene.film.width_px, 8);
        EXPECT_EQ(scene.film.height_px, 8);
    }
}

TEST(LandscapeScene, RefusesNumbersThatAreNone) {
    for (const std::int64_t triangles : {std::int64_t{0}, std::int64_t{-5}, std::int64_t{1'000'000'001}}) {
        EXPECT_THAT([&] { (void)landscape_scene(triangles, 8); },
                    testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("triangles")));
    }
}

}  // namespace
}  // namespace emulsion
