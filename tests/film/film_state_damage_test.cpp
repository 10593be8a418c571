// A film state that is not whole is refused, in one line, whatever is wrong with it.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>

#include "exr_fixture.h"
#include "film/film_state.h"
#include "film/film_state_checksum.h"
#include "film_state_fixture.h"

namespace emulsion {
namespace {

using emulsion::testing::every_film;
using emulsion::testing::state_with;
using ::testing::HasSubstr;

using FilmStateDamage = ExrFile;

FilmState small_state() { return state_with({.width_px = 2, .height_px = 2}, 0, 4); }

TEST_F(FilmStateDamage, TruncatedFilesAreRefusedAtEveryByte) {
    const fs::path path = file("a.film.exr");
    write_film_state(path, small_state());
    for (std::uintmax_t size = fs::file_size(path); size-- > 0;) {
        fs::resize_file(path, size);
        ASSERT_THAT([&] { static_cast<void>(read_film_state(path)); }, throws_io_error(path)) << size << " bytes";
    }
}

TEST_F(FilmStateDamage, FilesWithMoreBehindThemAreRefused) {
    const fs::path path = file("a.film.exr");
    write_film_state(path, small_state());
    write_bytes(path, read_text(path) + '\0');
    EXPECT_THAT([&] { static_cast<void>(read_film_state(path)); }, throws_io_error(path, HasSubstr("damaged")));
}

TEST_F(FilmStateDamage, AnyFlippedBitIsRefused) {
    const fs::path path = file("a.film.exr");
    write_film_state(path, small_state());
    const std::string whole = read_text(path);
    std::fstream bytes(path, std::ios::in | std::ios::out | std::ios::binary);
    const auto put = [&](std::size_t place, char byte) {
        bytes.seekp(static_cast<std::streamoff>(place));
        bytes.put(byte);
        bytes.flush();
    };
    for (std::size_t place = 0; place < whole.size(); ++place) {
        for (int bit = 0; bit < 8; ++bit) {
            put(place, static_cast<char>(whole[place] ^ (1 << bit)));
            ASSERT_THAT([&] { static_cast<void>(read_film_state(path)); }, throws_io_error(path))
                << "byte " << place << " of " << whole.size() << ", bit " << bit;
        }
        put(place, whole[place]);
    }
    EXPECT_TRUE(read_film_state(path) == small_state()) << "the test did not put back what it changed";
}

// Pieces of two versions of a file, as a file system may leave them after a crash.
// Nor does the reader of pictures take one for whole. Only where the mark itself is gone may it be a plain EXR, which
// then still has the right picture.
TEST_F(FilmStateDamage, NoFlippedBitChangesThePicture) {
    const fs::path path = file("a.film.exr");
    write_film_state(path, small_state());
    const Image<XYZ> expected = read_exr(path).xyz;
    const std::string whole = read_text(path);
    std::size_t refused = 0;
    for (std::size_t place = 0; place < whole.size(); ++place) {
        std::string flipped = whole;
        flipped[place] = static_cast<char>(flipped[place] ^ (1 << place % 8));
        write_bytes(path, flipped);
        try {
            ASSERT_EQ(read_exr(path).xyz, expected) << "byte " << place;
        } catch (const IoError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, whole.size() - 200) << "all but those of the mark";
}

TEST_F(FilmStateDamage, MixturesOfTwoStatesAreRefused) {
    write_film_state(file("a.film.exr"), state_with({.width_px = 20, .height_px = 30}, 0, 2),
                     {.compression = NoCompression{}});
    write_film_state(file("b.film.exr"), state_with({.width_px = 20, .height_px = 30}, 0, 3),
                     {.compression = NoCompression{}});
    const std::string a = read_text(file("a.film.exr")), b = read_text(file("b.film.exr"));
    for (std::size_t cut = 4096; cut < std::min(a.size(), b.size()); cut += 4096) {
        write_bytes(file("c.film.exr"), a.substr(0, cut) + b.substr(cut));
        EXPECT_THAT([&] { static_cast<void>(read_film_state(file("c.film.exr"))); },
                    throws_io_error(file("c.film.exr"), HasSubstr("damaged")));
    }
}

TEST_F(FilmStateDamage, OtherVersionsAreNamed) {
    const fs::path path = file("a.film.exr");
    write_film_state(path, small_state());
    std::string bytes = read_text(path);
    const std::string before = std::string("emulsion.filmStateVersion\0string\0\1\0\0\0", 37);
    ASSERT_NE(bytes.find(before + "2"), std::string::npos);
    bytes[bytes.find(before) + before.size()] = '1';
    write_bytes(path, bytes);
    EXPECT_THAT([&] { static_cast<void>(read_film_state(path)); }, throws_io_error(path, HasSubstr("damaged")));
    seal(path, path);
    EXPECT_THAT([&] { static_cast<void>(read_film_state(path)); },
                throws_io_error(path, HasSubstr("is a film state of version 1, expected 2")));
}

// Sealed by somebody who has changed a header: no damage, and no state either.
TEST_F(FilmStateDamage, SealedNonsenseIsRefused) {
    const fs::path path = file("a.film.exr");
    write_film_state(path, state_with(every_film()[1].options, 0, 2));
    const std::string whole = read_text(path);
    int refused = 0;
    const std::string first = "emulsion.state.";
    for (std::size_t at = whole.find(first); at != std::string::npos; at = whole.find(first, at + 1)) {
        for (std::size_t place = at; place < at + 70; ++place) {
            std::string bytes = whole;
            bytes[place] = static_cast<char>(bytes[place] ^ 0x11);
            write_bytes(path, bytes);
            try {
                seal(path, path);
                static_cast<void>(read_film_state(path));
            } catch (const IoError& error) {
                ++refused;
                ASSERT_THAT(std::string(error.what()), ::testing::Not(HasSubstr("\n")));
            }
        }
    }
    EXPECT_GT(refused, 500);
}

TEST_F(FilmStateDamage, OtherFilesAreNoStates) {
    const auto refused = [&](const fs::path& path, const char* reason) {
        EXPECT_THAT([&] { static_cast<void>(read_film_state(path)); }, throws_io_error(path, HasSubstr(reason)));
    };
    refused(file("missing.film.exr"), "No such file");
    refused(file("."), "is a folder");
    write_bytes(file("text.film.exr"), "Dear sirs, this is a letter.");
    refused(file("text.film.exr"), "is not an EXR file");
    EXPECT_THROW(static_cast<void>(is_film_state(file("text.film.exr"))), IoError);
    write_exr(file("plain.exr"), picture(4, 3), metadata());
    refused(file("plain.exr"), "is a plain EXR, expected a film state");
    EXPECT_FALSE(is_film_state(file("plain.exr")));
}

TEST_F(FilmStateDamage, TheFileBeforeStaysUntilTheNewOneIsWhole) {
    const fs::path path = file("a.film.exr");
    write_film_state(path, small_state());
    FilmState bad = small_state();
    bad.options.aux = {{"X", {"Y"}}};
    EXPECT_THROW(write_film_state(path, bad), std::invalid_argument);
    EXPECT_TRUE(read_film_state(path) == small_state());
    EXPECT_EQ(files_in_folder(), 1u);
}

}  // namespace
}  // namespace emulsion
