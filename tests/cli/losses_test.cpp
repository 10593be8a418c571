// What a picture lost on its way to the file is said, with numbers.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/loss_warnings.h"
#include "film/exr_file.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Nothing but a sky of one colour and this brightness.
std::string sky(const std::string& scale, const std::string& film_and_filter = "") {
    return "Film \"rgb\" \"integer xresolution\" 40 \"integer yresolution\" 30\n" + film_and_filter +
           "\nWorldBegin\nLightSource \"infinite\" \"rgb L\" [1 0.1 0.1] \"float scale\" " + scale + "\n";
}

class Losses : public ::testing::Test {
  protected:
    [[nodiscard]] ProgramResult render(const std::string& scene, std::vector<std::string> more) const {
        write_text(folder_.file("sky.pbrt"), scene);
        more.insert(more.begin(), {"render", folder_.file("sky.pbrt"), "--quiet", "-o", exr_});
        return run_program(more);
    }

    TemporaryFolder folder_;
    const std::string exr_ = folder_.file("a.exr");
};

TEST_F(Losses, PixelsWithoutAValueAreCounted) {
    // One sample to a pixel: those that the filter's negative lobes drew have a negative weight, and no value.
    const ProgramResult result = render(sky("1", "PixelFilter \"mitchell\""), {"--spp", "1"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, ContainsRegex("emulsion: warning: [1-9][0-9]* of 1200 pixels have no value"));
    EXPECT_EQ(render(sky("1"), {"--spp", "1"}).err, "");
    // No weight of a Gaussian cancels another, but one sample at its rim has next to none.
    const ProgramResult rim =
        render(sky("1"), {"--spp", "1", "--splat", "--filter", "gaussian:x-radius=0.5,y-radius=0.5,sigma=0.1"});
    EXPECT_THAT(rim.err, ContainsRegex("[1-9][0-9]* of 1200 pixels have no value and are 0: no good samples, or too "
                                       "little weight of the filter"));
}

TEST_F(Losses, SaturatedPixelsAreCounted) {
    const ProgramResult result = render(sky("1e36"), {"--spp", "4", "--model", "spectral:32"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("1200 pixels have left the range of the film's sums"));
}

TEST_F(Losses, SamplesTooFaintForTheSumsAreCounted) {
    const ProgramResult result = render(sky("1e-25"), {"--spp", "4"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err,
                HasSubstr("4800 of 4800 samples are too faint for the film's sums, at most 2.8e-14 cd/m^2"));
}

TEST_F(Losses, ValuesTooLargeForTheFileAreCounted) {
    const ProgramResult result = render(sky("1e9"), {"--half", "--spp", "4", "--model", "spectral:32"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr(exr_ + ": 3600 channel values are too large for 16-bit floats"));
}

TEST(ExrLosses, TellEachKindAndNameTheTypeThatWasTooSmall) {
    const ExrWriteResult all{.too_high_count = 7,
                             .too_low_count = 6,
                             .vanished_positive_count = 5,
                             .vanished_negative_count = 4,
                             .non_finite_count = 3};
    EXPECT_THAT(cli::exr_losses(all, PixelType::half),
                ElementsAre("7 channel values are too large for 16-bit floats and were stored as 65504, the largest",
                            "6 channel values are negative and too large for 16-bit floats and were stored as -65504, "
                            "the lowest",
                            "5 channel values are too small for 16-bit floats and were stored as 0",
                            "4 channel values are negative and too small for 16-bit floats and were stored as 0",
                            "3 channel values are NaN or infinite and were stored as such"));
    EXPECT_THAT(
        cli::exr_losses({.too_high_count = 7, .non_finite_count = 3}, PixelType::float32),
        ElementsAre(HasSubstr("7 channel values are too large for 32-bit floats and were stored as 3.4028235e+38,"),
                    HasSubstr("3 channel values are NaN or infinite")));
    EXPECT_THAT(cli::exr_losses({}, PixelType::half), IsEmpty());
}

TEST_F(Losses, APictureOfBadSamplesOnlyIsAnError) {
    const ProgramResult result = render(sky("1e39"), {"--spp", "2", "--model", "spectral:32"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("emulsion: error: all 2400 samples were bad: 0 NaN, 2400 infinite, 0 of negative "
                                      "luminance; nothing was written\n"));
    EXPECT_THAT(folder_.names(), ElementsAre("sky.pbrt"));
}

}  // namespace
}  // namespace emulsion::testing
