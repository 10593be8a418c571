// `emulsion render` and `emulsion develop` as a user meets them: the files, the words, the exit codes.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/progress_display.h"
#include "film/exr_file.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// Until the process has a handler of its own for the signal, as the kernel tells; at most a minute.
void wait_until_caught(pid_t process, int signal) {
    for (int i = 0; i < 6000; ++i) {
        const std::string status = read_text("/proc/" + std::to_string(process) + "/status");
        const std::size_t at = status.find("SigCgt:");
        if (at == std::string::npos) return;
        const std::uint64_t caught = std::stoull(status.substr(at + 7), nullptr, 16);
        if ((caught >> (signal - 1) & 1u) != 0) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

class RenderProgram : public ::testing::Test {
  protected:
    RenderProgram() { write_text(scene_, kSmallScene); }

    ProgramResult render(std::vector<std::string> more) const {
        more.insert(more.begin(), {"render", scene_});
        return run_program(more);
    }

    TemporaryFolder folder_;
    const std::string scene_ = folder_.file("small.pbrt"), exr_ = folder_.file("a.exr"), png_ = folder_.file("a.png");
};

TEST_F(RenderProgram, WritesBothFilesAndSaysWhere) {
    const ProgramResult result = render({"-o", exr_, "--png", png_});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("wrote " + exr_ + "\nwrote " + png_ + "\n"));
    EXPECT_THAT(folder_.names(), ElementsAre("a.exr", "a.png", "small.pbrt"));
    const FilmImage image = read_exr(exr_);
    EXPECT_EQ(image.xyz.width(), 48);
    EXPECT_EQ(image.xyz.height(), 32);
    EXPECT_THAT(image.notes, IsEmpty());
    EXPECT_THAT(read_text(png_), StartsWith("\x89PNG"));
}

TEST_F(RenderProgram, HeaderSaysWhatMadeThePicture) {
    ASSERT_EQ(render({"-o", exr_, "--seed", "77", "--spp", "3", "--resolution", "20x10"}).exit_code, 0);
    const FilmImage image = read_exr(exr_);
    EXPECT_EQ(image.xyz.width(), 20);
    EXPECT_EQ(image.xyz.height(), 10);
    EXPECT_EQ(image.metadata.samples_per_pixel, 3);
    EXPECT_EQ(image.metadata.sample_count, 600u);
    EXPECT_EQ(image.metadata.seed, 77u);
    EXPECT_THAT(image.metadata.renderer_version, StartsWith("emulsion "));
    EXPECT_EQ(image.metadata.command_line, std::string(EMULSION_PROGRAM) + " render " + scene_ + " -o " + exr_ +
                                               " --seed 77 --spp 3 --resolution 20x10");
}

TEST_F(RenderProgram, EveryNumberOfThreadsGivesTheSameBits) {
    for (const std::string& scene : {scene_, kCornellBox}) {
        const std::vector<std::string> common{"render", scene, "--quiet", "--resolution", "60x50", "--spp", "20"};
        std::vector<Image<XYZ>> pictures;
        for (const char* threads : {"1", "2", "3", "8"}) {
            auto arguments = common;
            arguments.insert(arguments.end(), {"-o", exr_, "--threads", threads});
            ASSERT_EQ(run_program(arguments).exit_code, 0);
            pictures.push_back(read_exr(exr_).xyz);
        }
        for (const Image<XYZ>& picture : pictures) EXPECT_TRUE(picture == pictures[0]) << scene;

        auto other_seed = common;
        other_seed.insert(other_seed.end(), {"-o", exr_, "--seed", "1"});
        ASSERT_EQ(run_program(other_seed).exit_code, 0);
        EXPECT_FALSE(read_exr(exr_).xyz == pictures[0]) << scene;
    }
}

TEST_F(RenderProgram, DevelopGivesTheSameBytesAsRenderDid) {
    const std::string again = folder_.file("again.png");
    for (const std::vector<std::string>& more :
         std::vector<std::vector<std::string>>{{},
                                               {"--rgb"},
                                               {"--half"},
                                               {"--rgb", "--half"},
                                               {"--space", "acescg-ap1", "--compression", "none"},
                                               {"--compression", "pxr24"},
                                               {"--half", "--compression", "b44"},
                                               {"--rgb", "--compression", "dwaa:level=200"},
                                               {"--tonemap", "max-to-white"}}) {
        std::vector<std::string> arguments{"-o", exr_, "--png", png_};
        arguments.insert(arguments.end(), more.begin(), more.end());
        ASSERT_EQ(render(arguments).exit_code, 0);
        std::vector<std::string> develop{"develop", exr_, "-o", again};
        if (more.size() == 2 && more[0] == "--tonemap") develop.insert(develop.end(), more.begin(), more.end());
        const ProgramResult result = run_program(develop);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_TRUE(read_text(again) == read_text(png_)) << ::testing::PrintToString(more);
    }
}

TEST_F(RenderProgram, ThePngMayHaveAnyPipeline) {
    const std::string pipeline = folder_.file("pipeline"), again = folder_.file("b.png");
    write_text(pipeline, "display=hdr10:peak=600 bits=10 dither=none\ntonemap=max-to-white\n");
    const ProgramResult result = render({"-o", exr_, "--png", png_, "--tonemap", "drago", "--pipeline", pipeline});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(read_text(png_), HasSubstr("cICP"));
    EXPECT_THAT(read_text(png_), HasSubstr("tonemap=drago"));
    EXPECT_THAT(read_text(png_), HasSubstr("display=hdr10:peak=600,black=0,flare=0"));
    ASSERT_EQ(run_program({"develop", exr_, "-o", again, "--pipeline", pipeline, "--tonemap", "drago"}).exit_code, 0);
    EXPECT_EQ(read_text(again), read_text(png_));
    // What a PNG can't say is found out before the scene is read.
    const ProgramResult refused =
        run_program({"render", "none", "--png", png_, "--pipeline", "range=narrow transfer=bt1886"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, StartsWith("emulsion: error: pipeline: PNG with range narrow"));
}

TEST_F(RenderProgram, SpaceAndCompressionAreThoseOfTheFile) {
    ASSERT_EQ(render({"-o", exr_, "--space", "rec2020", "--compression", "piz"}).exit_code, 0);
    const Imf::InputFile in(exr_.c_str());
    EXPECT_EQ(in.header().compression(), Imf::PIZ_COMPRESSION);
    EXPECT_EQ(Imf::chromaticities(in.header()).green, Imath::V2f(0.17f, 0.797f));
    EXPECT_NE(in.header().channels().findChannel("G"), nullptr);
    ASSERT_EQ(render({"-o", exr_, "--rgb"}).exit_code, 0);
    const Image<XYZ> by_flag = read_exr(exr_).xyz;
    ASSERT_EQ(render({"-o", exr_, "--space", "sRGB"}).exit_code, 0);
    EXPECT_EQ(read_exr(exr_).xyz, by_flag);
}

// ISO 400 stores four times the numbers, and says that 1 stands for 0.25 cd/m^2: what is read, and the picture made of
// it, are the same, to the bit for a power of two.
TEST_F(RenderProgram, ExposureIsInTheFilesWhiteLuminance) {
    const auto pictures_of = [&](const std::string& iso) {
        std::string scene = kSmallScene;
        scene.insert(scene.find("Film \"rgb\"") + 10, " \"float iso\" " + iso);
        write_text(scene_, scene);
        const ProgramResult result = render({"-o", exr_, "--png", png_});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return std::pair(read_exr(exr_), read_text(png_));
    };
    const auto [plain, plain_png] = pictures_of("100");
    const auto [bright, bright_png] = pictures_of("400");
    EXPECT_EQ(plain.white_luminance_cdm2, 1.0);
    EXPECT_EQ(bright.white_luminance_cdm2, 0.25);
    EXPECT_TRUE(std::equal(plain.xyz.pixels().begin(), plain.xyz.pixels().end(), bright.xyz.pixels().begin()));
    EXPECT_EQ(plain_png, bright_png);
}

TEST_F(RenderProgram, ToneMappersDiffer) {
    const std::string other = folder_.file("other.png");
    ASSERT_EQ(render({"-o", exr_, "--png", png_}).exit_code, 0);
    ASSERT_EQ(run_program({"develop", exr_, "-o", other, "--tonemap", "reinhard-global:key=0.4"}).exit_code, 0);
    EXPECT_FALSE(read_text(png_) == read_text(other));
}

TEST_F(RenderProgram, NamesTheExrAfterTheSceneIfNotTold) {
    const auto in_folder = [this] { ASSERT_EQ(::chdir(folder_.path().c_str()), 0); };
    ASSERT_EQ(run_program({"render", scene_, "--quiet"}, {.before = in_folder}).exit_code, 0);
    EXPECT_THAT(folder_.names(), ElementsAre("small.exr", "small.pbrt"));
}

TEST_F(RenderProgram, QuietSaysNothing) {
    const ProgramResult result = render({"-o", exr_, "--png", png_, "--quiet"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
}

TEST_F(RenderProgram, ShowsLinesWithoutTerminalAndABarWithOne) {
    const ProgramResult lines = render({"-o", exr_});
    EXPECT_THAT(lines.err, HasSubstr("100%"));
    EXPECT_THAT(lines.err, Not(HasSubstr("\r")));
    const ProgramResult bar = run_program_on_terminal({"render", scene_, "-o", exr_});
    EXPECT_EQ(bar.exit_code, 0);
    EXPECT_THAT(bar.err, ::testing::ContainsRegex("\r\\[#+\\] 100%"));
    EXPECT_THAT(bar.err, HasSubstr("Msamples/s"));
}

TEST(ProgressText, IsShorterThanTheTerminal) {
    for (int columns = 1; columns < 200; ++columns) {
        for (const std::int64_t done : {0, 1000, 123456789, 200000000}) {
            const std::string text = cli::progress_text(done, 200000000, 12.3, columns);
            EXPECT_LT(text.size(), static_cast<std::size_t>(columns));
        }
    }
    EXPECT_EQ(cli::progress_text(50000000, 200000000, 10.0, 90),
              "[#######.......................]  25%  50.0 of 200.0 Msamples  5.00 Msamples/s  0:30 left");
    EXPECT_EQ(cli::progress_text(50000000, 200000000, 10.0, 80),
              "[#####...............]  25%  50.0 of 200.0 Msamples  5.00 Msamples/s  0:30 left");
    EXPECT_EQ(cli::progress_text(50000000, 200000000, 10.0, 0),
              " 25%  50.0 of 200.0 Msamples  5.00 Msamples/s  0:30 left");
}

TEST_F(RenderProgram, InterruptedItWritesWhatThereIs) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const auto interrupt = [signal](pid_t child) {
            wait_until_caught(child, signal);
            std::this_thread::sleep_for(std::chrono::milliseconds(500));
            ::kill(child, signal);
        };
        const auto start = std::chrono::steady_clock::now();
        const ProgramResult result = run_program({"render", scene_, "-o", exr_, "--png", png_, "--spp", "10000000"},
                                                 {.while_running = interrupt});
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.err, HasSubstr("emulsion: warning: stopped early"));
        const FilmImage image = read_exr(exr_);
        EXPECT_LT(image.metadata.samples_per_pixel, 10000000);
        EXPECT_GT(image.metadata.sample_count, 0u);
        EXPECT_THAT(folder_.names(), ElementsAre("a.exr", "a.png", "small.pbrt"));
    }
}

}  // namespace
}  // namespace emulsion::testing
