// `emulsion develop`: the files that it reads and writes.

#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/pfm_file.h"
#include "film/radiance_file.h"
#include "ramp_picture.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::HasSubstr;

// The picture's own XYZ: Y from 1 to 64 cd/m^2, colours outside Rec. 709 among them.
TEST(Develop, WritesTheScenesOwnLightByTheNamesEnding) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), pfm = folder.file("a.pfm"), hdr = folder.file("a.HDR");
    ProgramResult result = run_program({"develop", exr, "-o", pfm});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out, "wrote " + pfm + "\n");
    const Image<XYZ> read = read_pfm(pfm).xyz;
    for (int x = 0; x < 64; ++x) EXPECT_NEAR(read(x, 3).y, 1.0f + static_cast<float>(x), 1e-4);
    result = run_program({"develop", exr, "-o", hdr});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("components below 0 (colours outside Rec. 709) are stored as 0"));
    EXPECT_EQ(read_radiance(hdr).xyz.width(), 64);
    // With bloom, which comes before tone mapping, the light is another.
    EXPECT_EQ(run_program({"develop", exr, "-o", pfm, "--bloom", "quartic"}).exit_code, 0);
    EXPECT_GT(std::abs(read_pfm(pfm).xyz(63, 3).y - read(63, 3).y), 0.01);
}

TEST(Develop, ReadsPicturesOfOthersByTheirContents) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder), pfm = folder.file("a.pfm"), png = folder.file("a.png");
    ASSERT_EQ(run_program({"develop", exr, "-o", pfm}).exit_code, 0);
    std::filesystem::rename(pfm, folder.file("picture.exr"));
    ProgramResult result = run_program({"develop", folder.file("picture.exr"), "-o", png});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("picture.exr: no primaries: taken as Rec. 709"));
    result = run_program({"develop", png, "-o", folder.file("again.png")});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("its white is taken as 1 cd/m^2"));
    write_text(folder.file("text"), "no picture");
    result = run_program({"develop", folder.file("text"), "-o", png});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err,
                HasSubstr("begins with \"no p\": expected an OpenEXR, Radiance (#?), PFM (PF or Pf) or PNG"));
}

TEST(Develop, PacksThePngAsAsked) {
    const TemporaryFolder folder;
    const std::string exr = write_ramp(folder);
    const auto size_at = [&](const std::string& level) {
        EXPECT_EQ(run_program({"develop", exr, "-o", folder.file("a.png"), "--png-level", level}).exit_code, 0);
        return std::filesystem::file_size(folder.file("a.png"));
    };
    EXPECT_GT(size_at("0"), size_at("2"));
    const ProgramResult refused = run_program({"develop", exr, "-o", folder.file("a.png"), "--png-level", "10"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("--png-level: found \"10\", expected a whole number from 0 to 9"));
}

}  // namespace
}  // namespace emulsion::testing
