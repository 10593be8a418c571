// Film states: what is read is what was written, to the bit.

#include "film/film_state.h"

#include <string>
#include <utility>
#include <vector>

#include "exr_fixture.h"
#include "film/film_layers.h"
#include "film/film_metadata.h"
#include "film_state_fixture.h"

namespace emulsion {
namespace {

using emulsion::testing::add_samples;
using emulsion::testing::every_film;
using emulsion::testing::NamedFilm;
using emulsion::testing::provenance;
using emulsion::testing::state_with;
using ::testing::HasSubstr;

class FilmStateFile : public ExrFile {};

TEST_F(FilmStateFile, EveryKindOfFilmComesBackBitForBit) {
    for (const NamedFilm& film : every_film()) {
        const FilmState state = state_with(film.options, 0, 5);
        EXPECT_GT(state.contents.counts.dropped.count(), 0u) << film.name << " is too tame";
        write_film_state(file("a.film.exr"), state);
        EXPECT_TRUE(is_film_state(file("a.film.exr")));
        const FilmState read = read_film_state(file("a.film.exr"));
        EXPECT_TRUE(read == state) << film.name;
        EXPECT_EQ(read.sensor_text, to_text(film.options.sensor));
    }
}

}  // namespace
}  // namespace emulsion
