// `emulsion render --until`: tiles that stop on their own.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/film_state.h"
#include "run_program.h"
#include "scenes.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::HasSubstr;

class RenderUntil : public ::testing::Test {
  protected:
    RenderUntil() { write_text(scene_, kSmallScene); }

    [[nodiscard]] ProgramResult render(std::vector<std::string> more) const {
        more.insert(more.begin(), {"render", scene_});
        return run_program(more);
    }
    [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }

  private:
    TemporaryFolder folder_;
    const std::string scene_ = folder_.file("small.pbrt");
};

TEST_F(RenderUntil, TilesThatHadEnoughStayAsTheyAre) {
    const std::vector<std::string> arguments = {"-o", file("a.film.exr"), "--spp", "160", "--until", "2"};
    const ProgramResult first = render(arguments);
    EXPECT_THAT(first.out, HasSubstr("standard error of colour at most 2, estimated, in "));
    const FilmState whole = read_film_state(file("a.film.exr"));
    EXPECT_THAT(whole.provenance.sampling, HasSubstr(" until=2 "));
    const std::uint64_t least = min_samples_per_pixel(whole.contents), most = max_samples_per_pixel(whole.contents);
    EXPECT_EQ(least, 96u);
    EXPECT_GT(most, least);
    EXPECT_EQ(whole.metadata.samples_per_pixel, static_cast<std::int64_t>(least));
    EXPECT_THAT(first.out, HasSubstr("samples each"));
    EXPECT_THAT(run_program({"info", file("a.film.exr")}).out, HasSubstr("96 to " + std::to_string(most) + " reach"));

    ASSERT_EQ(render({"-o", file("b.film.exr"), "--spp", "72", "--until", "2"}).exit_code, 0);
    const ProgramResult rest = render({"-o", file("b.film.exr"), "--spp", "160", "--until", "2", "--resume"});
    EXPECT_THAT(rest.out, HasSubstr("which has samples 0-72 (fewer where tiles had enough) of each pixel"));
    EXPECT_TRUE(read_film_state(file("b.film.exr")).contents == whole.contents);

    const ProgramResult plain = render({"-o", file("b.film.exr"), "--spp", "160", "--resume"});
    EXPECT_EQ(plain.exit_code, 1);
    EXPECT_THAT(plain.err, HasSubstr("until=2"));
    for (const auto& [more, found] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--until", "0"}, "found \"0\", expected a colour difference in CIEDE2000, above 0"},
             {{"--until", "nan"}, "found \"nan\", expected a colour difference"},
             {{"--until", "1", "--splat"}, "--until: found --splat as well, expected one of the two"},
             {{"--until", "1", "--shard", "1/2"}, "--until: found --shard as well, expected one of the two"}}) {
        std::vector<std::string> all{"-o", file("c.film.exr")};
        all.insert(all.end(), more.begin(), more.end());
        const ProgramResult refused = render(all);
        EXPECT_EQ(refused.exit_code, 2);
        EXPECT_THAT(refused.err, HasSubstr(found));
    }
}

}  // namespace
}  // namespace emulsion::testing
