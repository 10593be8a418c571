// `emulsion merge` as a user meets it.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "film/film_layers.h"
#include "film_states.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class MergeProgram : public ::testing::Test {
  protected:
    MergeProgram() {
        write_film_state(a_, film_state(small_film(), 0, 3));
        write_film_state(b_, film_state(small_film(), 3, 4));
        write_film_state(c_, film_state(small_film(), 4, 8));
    }

    static ProgramResult merge(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "merge");
        return run_program(arguments);
    }
    void expect_refused(const std::vector<std::string>& arguments, int exit_code, const std::string& words) const {
        const std::vector<std::string> before = folder_.names();
        const ProgramResult result = merge(arguments);
        EXPECT_EQ(result.exit_code, exit_code);
        EXPECT_THAT(result.err, AllOf(StartsWith("emulsion: error: "), HasSubstr(words)));
        EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << "one line";
        EXPECT_EQ(folder_.names(), before);
    }

    TemporaryFolder folder_;
    const std::string a_ = folder_.file("a.film.exr"), b_ = folder_.file("b.film.exr"), c_ = folder_.file("c.film.exr"),
                      out_ = folder_.file("out.film.exr"), exr_ = folder_.file("out.exr"),
                      png_ = folder_.file("out.png");
};

TEST_F(MergeProgram, GivesTheStateOfOneRunInAnyOrder) {
    const FilmState whole = film_state(small_film(), 0, 8);
    for (const auto& films : {std::vector{a_, b_, c_}, {c_, a_, b_}, {b_, c_, a_}}) {
        const ProgramResult result = merge({films[0], films[1], films[2], "-o", out_});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.out, "3 films, 12x8 pixels, samples 0-8: 8 of each pixel\nwrote " + out_ + "\n");
        EXPECT_THAT(result.err, HasSubstr("1 of 768 samples were bad and kept out: 1 NaN"));
        FilmState merged = read_film_state(out_);
        EXPECT_THAT(merged.metadata.command_line, EndsWith("-o " + out_));
        merged.metadata.command_line = whole.metadata.command_line;
        EXPECT_TRUE(merged == whole);
    }
}

TEST_F(MergeProgram, GivesThePictureOfOneRun) {
    const ProgramResult result = merge({a_, c_, b_, "-o", exr_, "--quiet"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_FALSE(is_film_state(exr_));
    const FilmState whole = film_state(small_film(), 0, 8);
    write_exr(folder_.file("whole.exr"), picture_of(whole.contents, FilmSetup(whole.options)), whole.metadata,
              {.white_luminance_cdm2 = 2.0});
    const FilmImage merged = read_exr(exr_), expected = read_exr(folder_.file("whole.exr"));
    EXPECT_TRUE(static_cast<const FilmPicture&>(merged) == expected);
    EXPECT_EQ(merged.white_luminance_cdm2, 2.0);
    EXPECT_EQ(merged.metadata.sample_count, 767u);
    EXPECT_THAT(merged.notes, IsEmpty());
}

TEST_F(MergeProgram, SharesOfARenderAddUpToTheWhole) {
    const std::string scene = folder_.file("small.pbrt"), whole = folder_.file("whole.exr");
    write_text(scene, kSmallScene);
    std::vector<std::string> arguments = {"merge", "--quiet", "-o", exr_};
    for (const char* shard : {"3/3", "1/3", "2/3"}) {
        const std::string film = folder_.file(std::string("shard") + shard[0] + ".film.exr");
        const ProgramResult rendered = run_program({"render", scene, "--quiet", "--shard", shard, "-o", film});
        ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
        arguments.push_back(film);
    }
    const ProgramResult merged = run_program(arguments);
    ASSERT_EQ(merged.exit_code, 0) << merged.err;
    ASSERT_EQ(run_program({"render", scene, "--quiet", "-o", whole}).exit_code, 0);
    EXPECT_TRUE(read_exr(exr_).xyz == read_exr(whole).xyz);
    EXPECT_EQ(read_exr(exr_).metadata.sample_count, read_exr(whole).metadata.sample_count);
}

TEST_F(MergeProgram, OneFilmAloneIsWrittenAnew) {
    ASSERT_EQ(merge({a_, "-o", exr_, "--half", "--space", "rec2020", "--compression", "piz"}).exit_code, 0);
    EXPECT_EQ(read_exr(exr_).metadata.sample_count, 287u);
}

TEST_F(MergeProgram, ANameInCapitalsIsThatOfAStateAllTheSame) {
    const std::string capitals = folder_.file("OUT.FILM.EXR");
    ASSERT_EQ(merge({a_, b_, "-o", capitals}).exit_code, 0);
    EXPECT_TRUE(is_film_state(capitals));
}

TEST_F(MergeProgram, SaysWhatAFilmThatWasStoppedHas) {
    FilmState state = film_state(small_film(), 0, 3);
    state.provenance.partial = PartialRound{{3, 8}, 4, {1, 0, 0, 1, 1, 0}};
    write_film_state(a_, state);
    const ProgramResult result = merge({a_, "-o", out_});
    EXPECT_THAT(result.out, StartsWith("1 film, 12x8 pixels, samples 0-3 (and 3-8 in 3 of 6 tiles): 3 to 8 of each "
                                       "pixel\n"));
}

TEST_F(MergeProgram, ThePngIsThatOfDevelop) {
    const std::string again = folder_.file("again.png");
    for (const char* compression : {"zip", "dwaa"}) {
        ASSERT_EQ(merge({a_, b_, "-o", out_, "--png", png_, "--rgb", "--half", "--compression", compression,  //
                         "--tonemap", "max-to-white"})
                      .exit_code,
                  0);
        const ProgramResult developed = run_program({"develop", out_, "-o", again, "--tonemap", "max-to-white"});
        EXPECT_EQ(developed.exit_code, 0);
        EXPECT_EQ(developed.err, "") << "a film state is a picture like any other";
        EXPECT_TRUE(read_text(again) == read_text(png_));
    }
}

TEST_F(MergeProgram, ThePngMayHaveAnyPipeline) {
    const std::string again = folder_.file("b.png"), pipeline = "display=rec2020 bits=5 dither=bayer";
    ASSERT_EQ(merge({a_, b_, "-o", exr_, "--png", png_, "--pipeline", pipeline}).exit_code, 0);
    ASSERT_EQ(run_program({"develop", exr_, "-o", again, "--pipeline", pipeline}).exit_code, 0);
    EXPECT_EQ(read_text(again), read_text(png_));
    EXPECT_THAT(read_text(png_), HasSubstr("display=rec2020"));
    expect_refused({a_, "-o", exr_, "--png", png_, "--pipeline", "range=narrow transfer=bt1886"}, 2, "range narrow");
}

TEST_F(MergeProgram, RefusesWhatDoesNotBelongTogether) {
    const std::string other = folder_.file("other.film.exr"), plain = folder_.file("plain.exr");
    FilmState state = film_state(small_film(), 8, 9);
    state.provenance.scene = "beef";
    write_film_state(other, state);
    expect_refused({a_, other, "-o", out_}, 1,
                   other + " does not go with " + a_ +
                       ": films do not belong together: scene is \"cafe0123\" of one "
                       "and \"beef\" of the other");
    expect_refused({a_, b_, other, "-o", out_}, 1, other + " does not go with " + a_ + " and " + b_ + ": ");
    expect_refused({a_, b_, c_, other, "-o", out_}, 1,
                   other + " does not go with " + a_ + ", " + b_ + " and " + c_ + ": ");
    const std::string d = folder_.file("d.film.exr");
    write_film_state(d, film_state(small_film(), 10, 11));
    expect_refused({a_, b_, c_, d, other, "-o", out_}, 1,
                   other + " does not go with " + a_ + ", " + b_ + ", " + c_ + " and 1 more: ");
    write_film_state(other, film_state(small_film(), 2, 5));
    expect_refused({a_, other, "-o", out_}, 1, "2-5 overlaps 0-3");
    state = film_state(small_film(), 8, 9);
    state.provenance.partial = PartialRound{{9, 12}, 4, {1, 0}};
    write_film_state(other, state);
    expect_refused({a_, other, "-o", out_}, 1, "1 of 2 tiles");
    write_exr(plain, Image<XYZ>(4, 4), {});
    expect_refused({a_, plain, "-o", out_}, 1, plain + ": is a plain EXR, expected a film state");
    expect_refused({a_, folder_.file("none.film.exr"), "-o", out_}, 1, "none.film.exr: No such file");
}

TEST_F(MergeProgram, RefusesToWriteOverItsInputs) {
    const std::string before = read_text(a_);
    expect_refused({a_, b_, "-o", a_}, 2, "--output: found " + a_ + ", which is the same file as FILM");
    expect_refused({a_, b_, "-o", out_, "--png", b_}, 2, "--png: found ");
    expect_refused({a_, a_, "-o", out_}, 2, "which is the same file as FILM");
    expect_refused({a_, "-o", folder_.file("a.png")}, 2, "expected a name ending in .exr");
    expect_refused({"-o", out_}, 2, "FILM");
    EXPECT_EQ(read_text(a_), before);
}

}  // namespace
}  // namespace emulsion::testing
