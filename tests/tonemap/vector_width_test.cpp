// Local adaptations have the same bits whichever vectors the processor has.

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include "test_pictures.h"
#include "tonemap/adaptation.h"

namespace emulsion {
namespace {

/// Only one of the instruction sets, until the end of the scope.
class OnlyTarget {
  public:
    explicit OnlyTarget(std::int64_t target) { choose(target); }
    ~OnlyTarget() { choose(0); }
    OnlyTarget(const OnlyTarget&) = delete;
    OnlyTarget& operator=(const OnlyTarget&) = delete;

  private:
    static void choose(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

/// All that the library was compiled for and that this processor has.
std::vector<std::int64_t> targets() { return hwy::SupportedAndGeneratedTargets(); }

TEST(VectorWidth, ThereIsMoreThanOne) {
#if HWY_ARCH_X86
    EXPECT_GE(targets().size(), 2u);
#endif
}

TEST(VectorWidth, SameBitsOfEveryLocalAdaptation) {
    Image<XYZ> scene = random_scene(301, 203, 13);
    scene(5, 7) = grey(-1.0f);
    scene(80, 40) = grey(0.0f);
    const SceneLuminance luminance(scene.view(), 1);
    for_each_alternative<Adaptation>([&](const auto& alternative) {
        if (!is_local(Adaptation{alternative})) return;
        const Image<float> widest = adapt(alternative, scene.view(), luminance, 1).local;
        for (const std::int64_t target : targets()) {
            const OnlyTarget only(target);
            EXPECT_EQ(adapt(alternative, scene.view(), luminance, 1).local, widest) << hwy::TargetName(target);
        }
    });
}

}  // namespace
}  // namespace emulsion
