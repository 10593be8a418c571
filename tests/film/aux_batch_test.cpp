// Batches of values of auxiliary layers are, bit for bit, their values one by one.

#include "film/aux_batch.h"

#include <cstddef>
#include <span>
#include <utility>

#include <gtest/gtest.h>

#include "film/film.h"
#include "sample_batch_fixture.h"

namespace emulsion {
namespace {

using emulsion::testing::BatchSamples;

constexpr PixelBounds kPlaces{1, 1, 6, 5};

TEST(AuxBatch, IsItsValuesOneByOne) {
    for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
        const FilmOptions options{.width_px = 7,
                                  .height_px = 5,
                                  .filter = MitchellFilter{},
                                  .filter_use = use,
                                  .aux = {known_aux_layer("normal"), {"id", {"value"}}}};
        // Bad values and weights among them.
        const BatchSamples samples(kPlaces, 1, 300);
        const std::span<const float> normals = samples.triples, ids = samples.radiance;
        Film one_by_one(options), batches(options);
        FilmTile expected = one_by_one.make_tile(kPlaces), got = batches.make_tile(kPlaces);
        for (std::size_t i = 0; i < samples.count(); ++i) {
            for (const auto& [layer, values] : {std::pair(0, normals.subspan(3 * i, 3)), {1, ids.subspan(i, 1)}}) {
                const auto at = static_cast<std::size_t>(layer);
                if (use == FilterUse::splatted) {
                    expected.add_aux_at(samples.x_px[i], samples.y_px[i], at, values);
                } else {
                    expected.add_aux(samples.x[i], samples.y[i], at, values, samples.weight[i]);
                }
            }
        }
        if (use == FilterUse::splatted) {
            add_aux_batch_at(got, samples.places(), {1, ids});
            add_aux_batch_at(got, samples.places(), {0, normals});
        } else {
            add_aux_batch(got, samples.pixels(), {1, ids});
            add_aux_batch(got, samples.pixels(), {0, normals});
        }
        one_by_one.merge(expected);
        batches.merge(got);
        EXPECT_TRUE(batches.contents() == one_by_one.contents());
        EXPECT_GT(batches.counts().dropped_aux, 50u);
        EXPECT_LT(batches.counts().dropped_aux, 100u);
    }
}

}  // namespace
}  // namespace emulsion
