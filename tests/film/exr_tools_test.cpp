// What other programs make of our files: oiiotool of Debian's openimageio-tools and exrheader of its openexr.

#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include "exr_fixture.h"
#include "film/exr_file.h"

namespace emulsion {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

/// What a command prints, with its exit code behind it.
std::string output_of(const std::string& command) {
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return "no pipe";
    std::string output;
    std::array<char, 4096> buffer{};
    for (std::size_t count = 1; count > 0;) {
        count = std::fread(buffer.data(), 1, buffer.size(), pipe);
        output.append(buffer.data(), count);
    }
    return output + "exit " + std::to_string(::pclose(pipe));
}

class ExrTools : public ExrFile {
  protected:
    void SetUp() override {
        const ExrOptions options{.space = "Rec2020",
                                 .pixel_type = PixelType::half,
                                 .compression = PizCompression{},
                                 .white_luminance_cdm2 = 0.25};
        write_exr(file("a.exr"), film_picture(), metadata(), options);
    }
};

TEST_F(ExrTools, ExrheaderReadsAFileWithEverythingInIt) {
    const std::string header = output_of("exrheader '" + file("a.exr").string() + "'");
    ASSERT_THAT(header, HasSubstr("exit 0")) << "is Debian's openexr installed?";
    for (const char* channel :
         {"R, 16-bit floating-point", "G, 16-bit floating-point", "B, 16-bit floating-point",
          "S0.386,667nm, 16-bit floating-point", "S0.550,938nm, 16-bit floating-point",
          "S0.828,000nm, 16-bit floating-point", "albedo.R, 16-bit floating-point", "depth.Z, 32-bit floating-point",
          "variance.Y, 32-bit floating-point", "samples, 32-bit unsigned integer"}) {
        EXPECT_THAT(header, HasSubstr(channel));
    }
    EXPECT_THAT(header, ContainsRegex("dataWindow \\(type box2i\\): \\(20 22\\) - \\(32 30\\)"));
    EXPECT_THAT(header, ContainsRegex("displayWindow \\(type box2i\\): \\(0 0\\) - \\(39 29\\)"));
    EXPECT_THAT(header, HasSubstr("red   (0.708 0.292)"));
    EXPECT_THAT(header, HasSubstr("green (0.17 0.797)"));
    EXPECT_THAT(header, HasSubstr("blue  (0.131 0.046)"));
    EXPECT_THAT(header, HasSubstr("white (0.3127 0.329)"));
    EXPECT_THAT(header, HasSubstr("whiteLuminance (type float): 0.25"));
    EXPECT_THAT(header, HasSubstr("adoptedNeutral (type v2f): (0.3127 0.329)"));
    EXPECT_THAT(header, HasSubstr("compression (type compression): piz"));
    EXPECT_THAT(header, HasSubstr("emissiveUnits (type string): \"W.m^-2.sr^-1\""));
    EXPECT_THAT(header, HasSubstr("emulsion.droppedInfiniteCount (type string): \"5\""));
}

TEST_F(ExrTools, OiiotoolReadsAFileWithEverythingInIt) {
    const std::string info = output_of("oiiotool --info -v '" + file("a.exr").string() + "'");
    ASSERT_THAT(info, HasSubstr("exit 0")) << "is Debian's openimageio-tools installed?";
    EXPECT_THAT(info, ContainsRegex("13 x +9, 12 channel"));
    for (const char* channel :
         {"R (half)", "G (half)", "B (half)", "S0.386,667nm (half)", "S0.550,938nm (half)", "S0.828,000nm (half)",
          "albedo.R (half)", "depth.Z (float)", "variance.Y (float)", "samples (uint)"}) {
        EXPECT_THAT(info, HasSubstr(channel));
    }
    EXPECT_THAT(info, ContainsRegex("pixel data origin: x=20, y=22"));
    EXPECT_THAT(info, ContainsRegex("full/display size: 40 x 30"));
    EXPECT_THAT(
        info, ContainsRegex("chromaticities: 0\\.708, 0\\.292, 0\\.17, 0\\.797, 0\\.131, 0\\.046, 0\\.3127, 0\\.329"));
    EXPECT_THAT(info, HasSubstr("whiteLuminance: 0.25"));
    EXPECT_THAT(info, HasSubstr("compression: \"piz\""));
}

}  // namespace
}  // namespace emulsion
