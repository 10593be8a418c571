// The stages up to tone mapping by their twins in double precision.

#include <utility>

#include <gtest/gtest.h>

#include "develop/contact_sheet.h"
#include "develop/develop.h"
#include "develop/pipeline.h"
#include "tonemap/single_precision.h"

namespace emulsion {
namespace {

/// An edge of 1 : 100 and a ramp, small enough for the twins of bloom and vision.
Image<XYZ> edge_picture() {
    Image<XYZ> scene(40, 24);
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            const float luminance = (x < 19 ? 100.0f : 1.0f) * (1.0f + 0.1f * static_cast<float>(y));
            scene(x, y) = {luminance, luminance, 0.8f * luminance};
        }
    }
    return scene;
}

Pipeline pipeline_of(const ToneMapper& mapper, const Precision& precision) {
    Pipeline pipeline;
    pipeline.tone_mapper = mapper;
    pipeline.precision = precision;
    pipeline.bits = 16;
    pipeline.dither = NoDither{};
    return pipeline;
}

XYZd white_of(const Pipeline& pipeline) {
    const XYZd white = shown_as_white(pipeline.scene_white, pipeline.display);
    // As tone mapping takes it.
    return {static_cast<float>(white.x), static_cast<float>(white.y), static_cast<float>(white.z)};
}

TEST(Precision, ReferenceIsTheTwinOfEachStage) {
    const Image<XYZ> scene = edge_picture();
    Pipeline pipeline = pipeline_of(HighContrast{}, ReferencePrecision{});
    pipeline.bloom = QuarticBloom{.radius = 0.2f, .weight = 0.3f};
    pipeline.vision = HumanVision{};
    const Image<XYZ> bloomed = in_single_precision(add_bloom_reference(pipeline.bloom, scene.view()));
    const Image<XYZ> seen = in_single_precision(see_reference(pipeline.vision, bloomed.view()));
    const Image<XYZ> expected = in_single_precision(
        tone_map_reference({pipeline.tone_mapper, pipeline.adaptation}, seen.view(), white_of(pipeline)));
    EXPECT_TRUE(tone_mapped(scene, pipeline, 1) == expected);
    EXPECT_TRUE(develop(scene, pipeline, 1).image == develop_tone_mapped(expected, pipeline, 1).image);
}

TEST(Precision, OnePictureForEveryNumberOfThreads) {
    const Pipeline pipeline = pipeline_of(Durand{}, ReferencePrecision{});
    EXPECT_TRUE(develop(edge_picture(), pipeline, 1).image == develop(edge_picture(), pipeline, 4).image);
}

// Local adaptations show the difference, at the edge; the text of a pipeline says which it was.
TEST(Precision, FastAndReferenceAreTwoPictures) {
    const Pipeline fast = pipeline_of(HighContrast{}, FastPrecision{}),
                   exact = pipeline_of(HighContrast{}, ReferencePrecision{});
    const Image<XYZ> scene = edge_picture();
    EXPECT_FALSE(develop(scene, fast, 1).image == develop(scene, exact, 1).image);
    EXPECT_TRUE(develop(scene, parse_pipeline(to_text(exact)), 1).image == develop(scene, exact, 1).image);
    EXPECT_TRUE(tone_mapped(scene, fast, 1) ==
                tone_map({fast.tone_mapper, fast.adaptation}, scene.view(),
                         {static_cast<float>(white_of(fast).x), 1.0f, static_cast<float>(white_of(fast).z)}, 1)
                    .image);
}

TEST(Precision, ContactSheetsHaveItToo) {
    const std::vector<ContactTile> tiles = {{{.mapper = HighContrast{}}, "high-contrast"}};
    const auto sheet = [&](const Precision& precision) {
        return contact_sheet(edge_picture(), pipeline_of(Exposure{}, precision), tiles, 40, 1);
    };
    EXPECT_FALSE(sheet(FastPrecision{}) == sheet(ReferencePrecision{}));
}

}  // namespace
}  // namespace emulsion
