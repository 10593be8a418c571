// What headers say, without pixels.

#include "film/exr_info.h"

#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include "exr_fixture.h"
#include "film/film_state.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

using ExrInfoFile = ExrFile;

TEST_F(ExrInfoFile, KnowsItsOwnFiles) {
    write_exr(file("a.exr"), picture(7, 5), metadata(),
              {.pixel_type = PixelType::half, .compression = PizCompression{}});
    ExrInfo info = read_exr_info(file("a.exr"));
    EXPECT_EQ(info.kind, ExrKind::film_picture);
    EXPECT_EQ(info.space, "XYZ");
    EXPECT_EQ(info.metadata, metadata());
    ASSERT_THAT(info.parts, SizeIs(1));
    EXPECT_EQ(info.parts[0].compression, "piz");
    EXPECT_EQ(info.parts[0].data_window, (PixelBounds{0, 0, 7, 5}));
    EXPECT_THAT(info.parts[0].channels,
                ElementsAre(ExrChannelInfo{"X", "half"}, ExrChannelInfo{"Y", "half"}, ExrChannelInfo{"Z", "half"}));

    const Film film({.width_px = 8, .height_px = 6, .crop = PixelBounds{1, 2, 4, 6}});
    write_film_state(file("b.film.exr"), state_of(film, {}, {}), {.space = "sRGB"});
    info = read_exr_info(file("b.film.exr"));
    EXPECT_EQ(info.kind, ExrKind::film_state);
    EXPECT_EQ(info.space, "sRGB");
    ASSERT_THAT(info.parts, SizeIs(2));
    EXPECT_EQ(info.parts[0].name, "picture");
    EXPECT_EQ(info.parts[1].name, "sums");
    EXPECT_THAT(info.parts[1].channels, SizeIs(12));
    EXPECT_EQ(info.parts[1].channels[0], (ExrChannelInfo{"X.0", "uint"}));
    EXPECT_EQ(info.parts[0].data_window, (PixelBounds{1, 2, 4, 6}));
    EXPECT_EQ(info.parts[0].display_window, (PixelBounds{0, 0, 8, 6}));
}

TEST_F(ExrInfoFile, NamesEverySpaceByItsPrimaries) {
    for (const std::string& space : exr_space_names()) {
        write_exr(file("a.exr"), picture(2, 2), {}, {.space = space});
        const std::string found = read_exr_info(file("a.exr")).space;
        if (found == space) continue;
        // Another name for the same primaries and white.
        write_exr(file("b.exr"), picture(2, 2), {}, {.space = found});
        EXPECT_EQ(read_exr_info(file("b.exr")).space, found);
        EXPECT_TRUE(same_bits(read_exr(file("a.exr")).xyz, read_exr(file("b.exr")).xyz)) << space << ", " << found;
    }
}

/// Of one part with these channels; no pixels, which headers can do without.
void write_header(const fs::path& path, const std::vector<const char*>& channels) {
    Imf::Header header(3, 2);
    for (const char* name : channels) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    const Imf::OutputFile out(path.c_str(), header);
}

TEST_F(ExrInfoFile, TellsOthersApart) {
    write_header(file("a.exr"), {"B", "G", "R", "A"});
    EXPECT_EQ(read_exr_info(file("a.exr")).kind, ExrKind::picture);
    EXPECT_EQ(read_exr_info(file("a.exr")).space, "sRGB") << "what read_exr() takes it for";
    write_header(file("b.exr"), {"Z", "normal.X"});
    const ExrInfo info = read_exr_info(file("b.exr"));
    EXPECT_EQ(info.kind, ExrKind::other);
    EXPECT_EQ(info.space, "");
    EXPECT_THAT(info.parts.at(0).channels,
                ElementsAre(ExrChannelInfo{"Z", "float"}, ExrChannelInfo{"normal.X", "float"}));
    write_bytes(file("c.exr"), "text");
    EXPECT_THAT([&] { static_cast<void>(read_exr_info(file("c.exr"))); }, throws_io_error(file("c.exr")));
}

}  // namespace
}  // namespace emulsion
