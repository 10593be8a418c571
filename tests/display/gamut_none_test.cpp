#include "display/gamut_none.h"

#include <vector>

#include <gtest/gtest.h>

#include "display/gamut_mapper.h"
#include "gamut_fixture.h"

namespace emulsion {
namespace {

TEST(GamutNone, LeavesWhatIsOutside) {
    std::vector<RGB> pixels{{1.5f, -0.25f, kNan}, {kInf, -kInf, 1.0f}};
    const GamutCounts counts = map_gamut(GamutNone{}, display_gamut(SrgbDisplay{}), pixels);
    EXPECT_TRUE(same_bits(pixels[0], {1.5f, -0.25f, 0.0f}));
    EXPECT_TRUE(same_bits(pixels[1], {kInf, -kInf, 1.0f}));
    EXPECT_EQ(counts, (GamutCounts{1, 1, kInf}));
}

}  // namespace
}  // namespace emulsion
