#include <cstddef>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include "exr_fixture.h"
#include "film/exr_file.h"

namespace emulsion {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct ForeignFile {
    std::vector<std::string> channels = {"R", "G", "B"};
    Imf::PixelType type = Imf::FLOAT;
    Imath::Box2i window{{0, 0}, {4, 2}};
    Imf::Compression compression = Imf::PIZ_COMPRESSION;
};

/// Every channel of pixel i holds i + 1.
template <class Prepare>
void write_foreign(const fs::path& path, const ForeignFile& what, const Prepare& prepare) {
    Imf::Header header(what.window, what.window);
    header.compression() = what.compression;
    for (const std::string& name : what.channels) header.channels().insert(name, Imf::Channel(what.type));
    prepare(header);
    const int width = what.window.max.x - what.window.min.x + 1, height = what.window.max.y - what.window.min.y + 1;
    std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::vector<unsigned> whole(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<float>(i + 1);
        whole[i] = static_cast<unsigned>(i + 1);
    }
    const void* data = what.type == Imf::UINT ? static_cast<const void*>(whole.data()) : values.data();
    Imf::FrameBuffer pixels;
    for (const std::string& name : what.channels) pixels.insert(name, Imf::Slice::Make(what.type, data, what.window));
    Imf::OutputFile out(path.c_str(), header);
    out.setFrameBuffer(pixels);
    out.writePixels(height);
}
void write_foreign(const fs::path& path, const ForeignFile& what) {
    write_foreign(path, what, [](Imf::Header&) {});
}

TEST_F(ExrFile, ForeignRgbWithoutChromaticitiesIsTakenAsRec709AndSaid) {
    write_foreign(file("a.exr"), {});
    const FilmImage read = read_exr(file("a.exr"));
    // Y of an equal R, G and B is that number in every space whose white has Y = 1.
    EXPECT_NEAR(read.xyz(4, 2).y, 15.0f, 1e-5f);
    EXPECT_NEAR(read.xyz(0, 0).x, 0.3127f / 0.329f, 1e-6f);
    EXPECT_THAT(read.notes, ElementsAre(HasSubstr("chromaticities"), HasSubstr("whiteLuminance")));
    EXPECT_EQ(read.metadata, FilmMetadata{});
}

TEST_F(ExrFile, ForeignChromaticitiesAndWhiteLuminanceCount) {
    write_foreign(file("a.exr"), {}, [](Imf::Header& header) {
        // The primaries of XYZ under the names R G B, as some programs write it.
        Imf::addChromaticities(header, {{1, 0}, {0, 1}, {0, 0}, {1.0f / 3.0f, 1.0f / 3.0f}});
        Imf::addWhiteLuminance(header, 80.0f);
    });
    const FilmImage read = read_exr(file("a.exr"));
    EXPECT_NEAR(read.xyz(1, 0).x, 160.0f, 1e-4f);
    EXPECT_NEAR(read.xyz(1, 0).y, 160.0f, 1e-4f);
    EXPECT_NEAR(read.xyz(1, 0).z, 160.0f, 1e-4f);
    EXPECT_THAT(read.notes, IsEmpty());
}

TEST_F(ExrFile, DegenerateChromaticitiesAreRefused) {
    write_foreign(file("a.exr"), {}, [](Imf::Header& header) {
        Imf::addChromaticities(header, {{0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}});
    });
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("a.exr"))); }, throws_io_error(file("a.exr")));
}

TEST_F(ExrFile, DataWindowMayLieAnywhere) {
    ForeignFile what;
    what.window = {{-7, 100}, {-3, 102}};
    write_foreign(file("a.exr"), what);
    const FilmImage read = read_exr(file("a.exr"));
    EXPECT_EQ(read.data_window, (PixelBounds{0, 0, 5, 3})) << "the frame's first pixel is (0, 0)";
    EXPECT_EQ(read.width_px, 5);
    EXPECT_EQ(read.height_px, 3);
    EXPECT_NEAR(read.xyz(4, 2).y, 15.0f, 1e-5f);

    write_foreign(file("a.exr"), what, [](Imf::Header& header) { header.displayWindow() = {{-10, 98}, {89, 197}}; });
    const FilmImage crop = read_exr(file("a.exr"));
    EXPECT_EQ(crop.data_window, (PixelBounds{3, 2, 8, 5}));
    EXPECT_EQ(crop.width_px, 100);
    EXPECT_EQ(crop.height_px, 100);
}

TEST_F(ExrFile, OtherChannelsBecomeLayersOrAreLeftOutAndSaid) {
    ForeignFile what;
    what.channels = {"A", "B", "G", "R", "X", "Y", "Z", "albedo.R"};
    write_foreign(file("a.exr"), what);
    const FilmImage read = read_exr(file("a.exr"));
    EXPECT_EQ(read.xyz(1, 0), (XYZ{2.0f, 2.0f, 2.0f})) << "X Y Z come before R G B";
    ASSERT_EQ(read.floats.size(), 5u);
    EXPECT_EQ(read.floats[0].name, "A");
    EXPECT_EQ(read.floats[4].name, "albedo.R");
    EXPECT_EQ(read.floats[4].values(4, 2), 15.0f);
    EXPECT_THAT(read.notes, ElementsAre(HasSubstr("whiteLuminance")));

    const FilmImage picture_only = read_exr(file("a.exr"), {.layers = ExrLayers::skip});
    EXPECT_EQ(picture_only.xyz, read.xyz);
    EXPECT_THAT(picture_only.floats, IsEmpty());
    EXPECT_THAT(picture_only.notes, ElementsAre(HasSubstr("channel A"), HasSubstr("channel B"), HasSubstr("channel G"),
                                                HasSubstr("channel R"), HasSubstr("whiteLuminance")));
}

TEST_F(ExrFile, OtherKindsOfChannelsAreRefused) {
    ForeignFile grey;
    grey.channels = {"Y", "RY", "BY"};
    write_foreign(file("grey.exr"), grey);
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("grey.exr"))); },
                throws_io_error(file("grey.exr"), HasSubstr("BY RY Y, expected X Y Z or R G B")));
    ForeignFile whole;
    whole.type = Imf::UINT;
    write_foreign(file("whole.exr"), whole);
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("whole.exr"))); },
                throws_io_error(file("whole.exr"), HasSubstr("channel R holds whole numbers")));
}

TEST_F(ExrFile, TiledFilesAreRead) {
    Imf::Header header(5, 3);
    for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(64, 64, Imf::ONE_LEVEL));
    const std::vector<float> values(15, 2.0f);
    {
        Imf::FrameBuffer pixels;
        for (const char* name : {"R", "G", "B"}) {
            pixels.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
        }
        Imf::TiledOutputFile out(file("a.exr").c_str(), header);
        out.setFrameBuffer(pixels);
        out.writeTile(0, 0);
    }
    EXPECT_NEAR(read_exr(file("a.exr")).xyz(3, 1).y, 2.0f, 1e-6f);
}

TEST_F(ExrFile, MetadataThatIsNoNumberIsLeftOutAndSaid) {
    write_foreign(file("a.exr"), {}, [](Imf::Header& header) {
        header.insert("emulsion.seed", Imf::StringAttribute("12x"));
        header.insert("emulsion.samplesPerPixel", Imf::StringAttribute("99999999999999999999"));
        header.insert("emulsion.rendererVersion", Imf::StringAttribute("7"));
    });
    const FilmImage read = read_exr(file("a.exr"));
    EXPECT_EQ(read.metadata.seed, 0u);
    EXPECT_EQ(read.metadata.renderer_version, "7");
    EXPECT_THAT(read.notes, Contains(HasSubstr("emulsion.seed is \"12x\"")));
    EXPECT_THAT(read.notes, Contains(HasSubstr("emulsion.samplesPerPixel")));
}

}  // namespace
}  // namespace emulsion
