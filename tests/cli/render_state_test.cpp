// `emulsion render` with film states: checkpoints, resumed and killed renders, shards.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "film/exr_file.h"
#include "film/film_state.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Pixels and layers of two files, bit for bit.
bool same_picture(const FilmImage& a, const FilmImage& b) {
    return static_cast<const FilmPicture&>(a) == static_cast<const FilmPicture&>(b);
}

class RenderState : public ::testing::Test {
  protected:
    RenderState() { write_text(scene_, kSmallScene); }

    ProgramResult render(std::vector<std::string> more, const RunOptions& options = {}) const {
        more.insert(more.begin(), {"render", scene_});
        return run_program(more, options);
    }
    [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }

    /// That going on from `state` with these arguments is an error that says this.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& reason) const {
        std::vector<std::string> all{"-o", file("a.film.exr"), "--resume"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const ProgramResult result = render(all);
        EXPECT_EQ(result.exit_code, 1) << ::testing::PrintToString(arguments);
        EXPECT_THAT(result.err, StartsWith("emulsion: error: can't resume from " + file("a.film.exr") + ": "));
        EXPECT_THAT(result.err, HasSubstr(reason));
    }

    TemporaryFolder folder_;
    const std::string scene_ = folder_.file("small.pbrt");
};

// What a render reads is not written over: a camera's curves, the state that it goes on from, a scene's spectra.
TEST_F(RenderState, OutputsDoNotLandOnInputs) {
    const auto expect_kept = [&](const std::string& input, std::vector<std::string> arguments) {
        const std::string before = read_text(input);
        arguments.insert(arguments.end(), {"-o", file("a.exr"), "--quiet", "--png", input});
        const ProgramResult result = render(arguments);
        EXPECT_EQ(result.exit_code, 2) << result.err;
        EXPECT_THAT(result.err, HasSubstr("--png"));
        EXPECT_TRUE(read_text(input) == before) << input;
    };
    write_text(file("camera.csv"), "wavelength,r,g,b\n400,0,0,1\n500,0,1,1\n600,1,1,0\n700,1,0,0\n");
    expect_kept(file("camera.csv"), {"--sensor", file("camera.csv")});
    ASSERT_EQ(render({"-o", file("a.exr"), "--checkpoint", "9", "--quiet"}).exit_code, 0);
    expect_kept(file("a.film.exr"), {"--resume"});
    write_text(file("lamp.spd"), "400 1 700 2\n");
    const std::string lamp = "LightSource \"point\" \"spectrum I\" \"lamp.spd\"\n";
    write_text(scene_, kSmallScene + lamp + lamp);
    expect_kept(file("lamp.spd"), {});
    EXPECT_EQ(render({"-o", file("a.exr"), "--quiet"}).exit_code, 0) << "what is read twice is no conflict";
}

// Kills at moments spread over the run; whatever was lost, the end is that of a run that nobody killed.
TEST_F(RenderState, KilledAgainAndAgainItEndsWithTheSameBytes) {
    const std::vector<std::string> common{"--spp",      "64",  "--splat", "--aov",      "albedo,depth",
                                          "--variance", "xyz", "--quiet", "--spectrum", "3"};
    const auto arguments = [&](const std::string& name, std::vector<std::string> more) {
        more.insert(more.end(), common.begin(), common.end());
        more.insert(more.end(), {"-o", file(name + ".exr"), "--png", file(name + ".png")});
        return more;
    };
    const auto begun = std::chrono::steady_clock::now();
    ASSERT_EQ(render(arguments("whole", {})).exit_code, 0);
    const auto whole_run = std::chrono::steady_clock::now() - begun;

    int killed = 0;
    constexpr int kKills = 12;
    for (int i = 0; i < kKills; ++i) {
        const auto kill_later = [&](pid_t child) {
            std::this_thread::sleep_for(whole_run * (i + 1) / (kKills + 2));
            ::kill(child, SIGKILL);
        };
        const ProgramResult result =
            render(arguments("killed", {"--checkpoint", "0.02", "--resume"}), {.while_running = kill_later});
        EXPECT_EQ(result.err, "");
        killed += result.exit_code == -1 ? 1 : 0;
    }
    EXPECT_GE(killed, 1);
    ASSERT_EQ(render(arguments("killed", {"--checkpoint", "0.02", "--resume"})).exit_code, 0);
    EXPECT_TRUE(same_picture(read_exr(file("killed.exr")), read_exr(file("whole.exr"))));
    EXPECT_TRUE(read_text(file("killed.png")) == read_text(file("whole.png")));
}

TEST_F(RenderState, CheckpointsAreWholeAtEveryMoment) {
    int readings = 0;
    std::uint64_t samples = 0;
    const auto read_on = [&](pid_t child) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while ((readings < 40 || samples == 0) && std::chrono::steady_clock::now() < end) {
            if (!std::filesystem::exists(file("a.film.exr"))) continue;
            ++readings;
            try {
                const FilmState state = read_film_state(file("a.film.exr"));
                EXPECT_GE(state.contents.counts.samples, samples);
                samples = state.contents.counts.samples;
            } catch (const std::exception& error) {
                ADD_FAILURE() << error.what();
                break;
            }
        }
        ::kill(child, SIGINT);
    };
    const ProgramResult result = render({"-o", file("a.exr"), "--spp", "10000000", "--checkpoint", "0.001", "--quiet"},
                                        {.while_running = read_on});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_GE(readings, 40);
    EXPECT_GT(samples, 0u);
    // The last one is written after the interrupt, and is of the picture.
    const FilmState last = read_film_state(file("a.film.exr"));
    EXPECT_EQ(last.contents.counts.samples, read_exr(file("a.exr")).metadata.sample_count);
}

TEST_F(RenderState, ShardsAddUpToTheSingleRun) {
    const auto shard = [this](const std::string& name, std::vector<std::string> more) {
        more.insert(more.end(), {"--spp", "7", "--quiet", "-o", file(name), "--filter", "mitchell"});
        const ProgramResult result = render(more);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return read_film_state(file(name));
    };
    const FilmState whole = shard("whole.film.exr", {});
    FilmState sum = shard("2.film.exr", {"--shard", "2/3", "--checkpoint", "60", "--resume"});
    EXPECT_EQ(to_text(sum.provenance.samples), "2-4");
    merge(sum, shard("3.film.exr", {"--shard", "3/3"}));
    merge(sum, shard("1.film.exr", {"--shard", "1/3"}));
    EXPECT_TRUE(sum.contents == whole.contents);
    EXPECT_EQ(sum.provenance, whole.provenance);
}

TEST_F(RenderState, ResumedItSaysFromWhatAndGoesOnToMoreSamples) {
    const ProgramResult first = render({"-o", file("a.film.exr"), "--resume"});
    EXPECT_THAT(first.out, StartsWith("nothing to resume: there is no " + file("a.film.exr") + "\n"));
    const ProgramResult second = render({"-o", file("a.film.exr"), "--resume", "--spp", "9"});
    EXPECT_EQ(second.exit_code, 0) << second.err;
    EXPECT_THAT(second.out,
                StartsWith("resuming from " + file("a.film.exr") + ", which has samples 0-4 of each pixel\n"));
    ASSERT_EQ(render({"-o", file("b.film.exr"), "--spp", "9"}).exit_code, 0);
    EXPECT_TRUE(read_film_state(file("a.film.exr")).contents == read_film_state(file("b.film.exr")).contents);

    // Nothing left to do: only outputs are written, and beside a plain EXR the state stays.
    const ProgramResult third = render({"-o", file("a.exr"), "--resume", "--spp", "9"});
    EXPECT_EQ(third.exit_code, 0) << third.err;
    EXPECT_TRUE(read_exr(file("a.exr")).xyz == read_exr(file("b.film.exr")).xyz);
}

TEST_F(RenderState, ANameInCapitalsIsThatOfAStateAllTheSame) {
    const std::string capitals = file("A.FILM.EXR");
    const std::vector<std::string> arguments = {"-o", capitals, "--shard", "1/2", "--checkpoint", "9", "--resume"};
    ASSERT_EQ(render(arguments).exit_code, 0);
    EXPECT_TRUE(is_film_state(capitals));
    EXPECT_THAT(render(arguments).out, StartsWith("resuming from " + capitals));
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"A.FILM.EXR", "small.pbrt"})) << "no state beside the state";
}

TEST_F(RenderState, RefusesStatesOfOtherRenders) {
    ASSERT_EQ(render({"-o", file("a.film.exr")}).exit_code, 0);
    const std::string before = read_text(file("a.film.exr"));
    expect_refused({"--seed", "1"}, "seed=1");
    expect_refused({"--model", "spectral:8"}, "model=spectral:8");
    expect_refused({"--resolution", "48x33"}, "33");
    expect_refused({"--crop", "0,0,8,8"}, "crop");
    expect_refused({"--filter", "box"}, "box");
    expect_refused({"--splat"}, "splatted");
    expect_refused({"--variance", "xyz"}, "variance");
    expect_refused({"--observer", "1964"}, "1964");
    expect_refused({"--spp", "3"}, "it has samples 0-4 of each pixel, expected none outside 0-3");
    expect_refused({"--shard", "2/2", "--spp", "8"}, "it has samples 0-4 of each pixel, expected none outside 4-8");
    write_text(scene_, kSmallScene + std::string("# another\n"));
    expect_refused({}, "scene");
    EXPECT_TRUE(read_text(file("a.film.exr")) == before);

    write_text(scene_, kSmallScene);
    write_text(file("a.film.exr"), before.substr(0, before.size() / 2));
    EXPECT_EQ(render({"-o", file("a.film.exr"), "--resume"}).exit_code, 1);

    std::string stratified = kSmallScene;
    stratified.replace(stratified.find("\"independent\" \"integer pixelsamples\" 4"), 37,
                       "\"stratified\" \"integer xsamples\" 2 \"integer ysamples\" 2");
    write_text(scene_, stratified);
    ASSERT_EQ(render({"-o", file("a.film.exr")}).exit_code, 0);
    expect_refused({"--spp", "16"}, "a stratified sampler's strata depend on --spp");
}

// Each of 8 samples reaches 16 pixels and more: what people ask for, and pay for, is 8.
TEST_F(RenderState, SplattedSamplesAreCountedOnce) {
    const std::string filter = "mitchell:x-radius=2,y-radius=2", eight = "48x32 pixels, 8 samples each, in ";
    for (const std::string& name : {file("a.exr"), file("a.film.exr")}) {
        const ProgramResult result = render({"-o", name, "--spp", "8", "--splat", "--filter", filter});
        EXPECT_THAT(result.out, StartsWith(eight)) << result.err;
        EXPECT_EQ(read_exr(name).metadata.samples_per_pixel, 8);
    }
    // Places up to 2 px outside the picture reach into it.
    const std::string count = std::to_string(8 * 52 * 36);
    EXPECT_THAT(run_program({"info", file("a.exr")}).out,
                HasSubstr(" at least 8 of each pixel, " + count + " in all\n"));
    const std::string info = run_program({"info", file("a.film.exr")}).out;
    EXPECT_THAT(info, HasSubstr("samples          8 of each pixel, " + count + " in all\n                 1"));
    EXPECT_THAT(info, HasSubstr(" reach each pixel\n"));
    const std::string json = run_program({"info", "--json", file("a.film.exr")}).out;
    EXPECT_THAT(json, HasSubstr("\"samples_per_pixel\": 8,"));
    EXPECT_THAT(json, HasSubstr("\"most_samples_per_pixel\": 8,"));
    EXPECT_THAT(json, ::testing::ContainsRegex("\"fewest_samples_reaching_a_pixel\": 1[0-9][0-9],"));
}

TEST_F(RenderState, LayersAndCropAreInTheFile) {
    const ProgramResult result =
        render({"-o", file("a.exr"), "--crop", "8,4,40,28", "--aov", "depth,normal", "--variance", "luminance",
                "--spectrum", "2:400-700", "--firefly", "clamp:luminance=50", "--filter", "triangle:x-radius=1"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const FilmImage image = read_exr(file("a.exr"));
    EXPECT_EQ(image.data_window, (PixelBounds{8, 4, 40, 28}));
    EXPECT_EQ(image.width_px, 48);
    std::vector<std::string> names;
    for (const FloatChannel& channel : image.floats) names.push_back(channel.name);
    EXPECT_THAT(names, ::testing::UnorderedElementsAre("depth.Z", "normal.X", "normal.Y", "normal.Z", "variance.Y",
                                                       "standard-error.Y"));
    ASSERT_EQ(image.spectral.size(), 2u);
    EXPECT_EQ(image.spectral[0].centre_nm, 475.0);
    EXPECT_THAT(image.metadata.firefly_control, StartsWith("clamp:luminance=50; "));
    EXPECT_THAT(image.metadata.filter, StartsWith("triangle:x-radius=1"));
}

TEST_F(RenderState, BadUsageIsNamed) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"--crop", "1,2,3"},
                                               {"--crop", "4,0,4,8"},
                                               {"--variance", "rgb"},
                                               {"--aov", "albedo,motion"},
                                               {"--aov", "depth,depth"},
                                               {"--spectrum", "0"},
                                               {"--spectrum", "4:700-400"},
                                               {"--firefly", "median-of-means:groups=2"},
                                               {"--filter", "sinc:tau=0"},
                                               {"--observer", "nobody"},
                                               {"--checkpoint", "0"},
                                               {"--shard", "0/2", "-o", file("a.film.exr")},
                                               {"--shard", "3/2", "-o", file("a.film.exr")},
                                               {"--shard", "1/2", "-o", file("a.exr")},
                                               {"--shard", "1/2"}}) {
        const ProgramResult result = render(arguments);
        EXPECT_EQ(result.exit_code, 2) << ::testing::PrintToString(arguments) << result.err;
        EXPECT_THAT(result.err, HasSubstr(arguments[0])) << ::testing::PrintToString(arguments);
    }
    const ProgramResult empty = render({"--shard", "1/9", "--spp", "4", "-o", file("a.film.exr")});
    EXPECT_EQ(empty.exit_code, 1);
    EXPECT_THAT(empty.err, HasSubstr("--shard 1/9: this share of 4 samples per pixel is empty"));
    EXPECT_THAT(folder_.names(), ::testing::ElementsAre("small.pbrt"));
}

TEST_F(RenderState, ACameraAndAnObserverSeeOtherwise) {
    // A camera that is the 1931 observer, but for the scale of its channels and rough steps of 10 nm.
    std::string curves = "wavelength,r,g,b\n";
    for (int nm = 400; nm <= 700; nm += 10) {
        const auto bell = [nm](double centre, double width) {
            return std::exp(-0.5 * (nm - centre) * (nm - centre) / (width * width));
        };
        curves += std::to_string(nm) + ", " + std::to_string(bell(600, 35)) + ", " + std::to_string(bell(550, 40)) +
                  ", " + std::to_string(bell(450, 25)) + "\n";
    }
    write_text(file("camera.csv"), curves);
    const auto picture = [this](std::vector<std::string> more) {
        more.insert(more.end(), {"--quiet", "-o", file("a.exr")});
        const ProgramResult result = render(more);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return read_exr(file("a.exr")).xyz;
    };
    const Image<XYZ> plain = picture({}), camera = picture({"--sensor", file("camera.csv")});
    EXPECT_FALSE(plain == camera);
    EXPECT_FALSE(plain == picture({"--observer", "1964 10deg"}));
    EXPECT_EQ(render({"--sensor", file("none.csv"), "-o", file("b.exr")}).exit_code, 1);
}

}  // namespace
}  // namespace emulsion::testing
