// What a film file holds beside the picture: its place in the frame, layers, counts and spectra.

#include "film/exr_layers.h"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "exr_fixture.h"
#include "film/exr_file.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Image<float> as_halves(Image<float> image) {
    for (float& value : image.pixels()) value = static_cast<float>(half(value));
    return image;
}

TEST_F(ExrFile, CropsKeepTheirPlaceInTheFrame) {
    for (const PixelBounds window :
         {PixelBounds{20, 22, 33, 31}, PixelBounds{-5, -3, 8, 6}, PixelBounds{0, 0, 13, 9}}) {
        FilmPicture picture = film_picture();
        picture.data_window = window;
        write_exr(file("a.exr"), picture, {});
        const FilmImage read = read_exr(file("a.exr"));
        EXPECT_EQ(read.data_window, window);
        EXPECT_EQ(read.width_px, 40);
        EXPECT_EQ(read.height_px, 30);
        EXPECT_TRUE(same_bits(read.xyz, picture.xyz));
        const Imf::InputFile in(file("a.exr").c_str());
        EXPECT_EQ(in.header().displayWindow(), Imath::Box2i({0, 0}, {39, 29}));
        EXPECT_EQ(in.header().dataWindow(), Imath::Box2i({window.x0, window.y0}, {window.x1 - 1, window.y1 - 1}));
    }
}

TEST_F(ExrFile, LayersComeBack) {
    const FilmPicture picture = film_picture();
    for (ExrOptions options : kAllOptions) {
        options.white_luminance_cdm2 = 0.25;
        options.threads = 3;
        EXPECT_EQ(write_exr(file("a.exr"), picture, metadata(), options), ExrWriteResult{})
            << "a depth that is infinite is stored as it is";
        const FilmImage read = read_exr(file("a.exr"));
        const bool is_half = options.pixel_type == PixelType::half;
        FilmPicture expected = picture;
        expected.xyz = as_stored(picture.xyz, options);
        for (FloatChannel& channel : expected.floats) {
            if (is_half && channel.name.starts_with("albedo")) channel.values = as_halves(channel.values);
        }
        for (SpectralChannel& channel : expected.spectral) {
            if (is_half) channel.values = as_halves(channel.values);
        }
        EXPECT_EQ(static_cast<const FilmPicture&>(read), expected);
        EXPECT_THAT(read.notes, IsEmpty());
        EXPECT_EQ(read.metadata, metadata());

        const FilmImage picture_only = read_exr(file("a.exr"), {.layers = ExrLayers::skip});
        EXPECT_TRUE(same_bits(picture_only.xyz, read.xyz));
        EXPECT_TRUE(picture_only.floats.empty() && picture_only.counts.empty() && picture_only.spectral.empty());
        EXPECT_THAT(picture_only.notes, IsEmpty()) << "of our own files nothing is left out that was not meant to be";
    }
}

// Bands of rows, and the end of the last.
TEST_F(ExrFile, LargeLayersComeBack) {
    FilmPicture picture;
    picture.xyz = emulsion::picture(31, 301);
    picture.data_window = {0, 7, 31, 308};
    picture.width_px = 31;
    picture.height_px = 308;
    picture.floats.push_back({"albedo.R", Image<float>(31, 301)});
    picture.counts.push_back({"samples", Image<std::uint32_t>(31, 301)});
    for (int i = 0; i < 31 * 301; ++i) {
        picture.floats[0].values.pixels()[static_cast<std::size_t>(i)] = static_cast<float>(i % 2048);
        picture.counts[0].values.pixels()[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(i);
    }
    for (const char* space : {"XYZ", "Rec2020"}) {
        for (const PixelType type : {PixelType::float32, PixelType::half}) {
            const ExrOptions options{.space = space, .pixel_type = type, .threads = 1};
            write_exr(file("a.exr"), picture, {}, options);
            const FilmImage read = read_exr(file("a.exr"));
            EXPECT_TRUE(same_bits(read.xyz, as_stored(picture.xyz, options)));
            EXPECT_EQ(read.floats, picture.floats);
            EXPECT_EQ(read.counts, picture.counts);
        }
    }
}

TEST_F(ExrFile, LossesOfLayersCount) {
    FilmPicture picture = film_picture();
    picture.floats[0].values(0, 0) = 1e6f;
    picture.floats[1].values(0, 0) = -1e-20f;
    picture.spectral[0].values(0, 0) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(write_exr(file("a.exr"), picture, {}, {.pixel_type = PixelType::half}),
              (ExrWriteResult{.too_high_count = 1, .vanished_negative_count = 1, .non_finite_count = 1}));
    EXPECT_EQ(write_exr(file("a.exr"), picture, {}), (ExrWriteResult{.non_finite_count = 1}));
}

TEST_F(ExrFile, SpectraFollowThePublicLayout) {
    FilmPicture picture = film_picture();
    std::swap(picture.spectral[0], picture.spectral[2]);
    write_exr(file("a.exr"), picture, {}, {.pixel_type = PixelType::half});
    const Imf::InputFile in(file("a.exr").c_str());
    std::vector<std::string> names;
    for (auto it = in.header().channels().begin(); it != in.header().channels().end(); ++it) {
        names.emplace_back(it.name());
        const bool always_float = names.back() == "depth.Z" || names.back() == "variance.Y";
        EXPECT_EQ(it.channel().type, names.back() == "samples" ? Imf::UINT : always_float ? Imf::FLOAT : Imf::HALF);
    }
    EXPECT_THAT(names, ElementsAre("S0.386,667nm", "S0.550,938nm", "S0.828,000nm", "X", "Y", "Z", "albedo.B",
                                   "albedo.G", "albedo.R", "depth.Z", "samples", "variance.Y"));
    const auto text = [&](const char* name) { return in.header().typedAttribute<Imf::StringAttribute>(name).value(); };
    EXPECT_EQ(text("spectralLayoutVersion"), "1.0");
    EXPECT_EQ(text("emissiveUnits"), "W.m^-2.sr^-1");
    EXPECT_EQ(text("emulsion.spectralBuckets"), "386.6666666666667:53.333333333333336 550.938:10 828:4");
}

TEST(ExrLayers, ReadWavelengthsAsTheLayoutWritesThem) {
    EXPECT_EQ(wavelength_of_channel("S0.550,938nm"), 550.938);
    EXPECT_EQ(wavelength_of_channel("S0.5,5e2nm"), 550.0);
    EXPECT_EQ(wavelength_of_channel("S0.400nm"), 400.0);
    for (const char* other : {"S1.550nm", "T.550nm", "S0.nm", "S0.550um", "S0.-550nm", "S0.550.5nm", "S0.5 50nm",
                              "S0.infnm", "Y", "", "S0.5,5,0nm"}) {
        EXPECT_EQ(wavelength_of_channel(other), std::nullopt) << other;
    }
    for (double wavelength_nm = 100.0; wavelength_nm < 1000.0; wavelength_nm += 12.345) {
        const auto read = wavelength_of_channel(spectral_channel_name(wavelength_nm));
        ASSERT_TRUE(read);
        EXPECT_NEAR(*read, wavelength_nm, 0.0005000001);
    }
}

TEST(ExrLayers, BucketsOfOtherChannelsAreNotTaken) {
    const auto applied = [](const char* text) {
        std::vector<SpectralChannel> channels{{400.0, 0.0, {}}, {500.667, 0.0, {}}};
        apply_buckets_text(text, channels);
        return std::pair(channels[1].centre_nm, channels[1].width_nm);
    };
    EXPECT_EQ(applied("400:10 500.66666:20"), std::pair(500.66666, 20.0));
    for (const char* bad : {"", "400:10", "400:10 500.6:20", "400:10 500.667:-1", "400:10 500.667", "400:10 500.667:x",
                            "400:10 500.667:nan", "400:10 500.667:20 600:10", "400:10  500.667:20"}) {
        EXPECT_EQ(applied(bad), std::pair(500.667, 0.0)) << bad;
    }
}

TEST_F(ExrFile, RefusesPicturesThatAreNone) {
    const auto refused = [&](const char* what, const auto& spoil) {
        FilmPicture picture = film_picture();
        spoil(picture);
        EXPECT_THAT([&] { write_exr(file("a.exr"), picture, {}); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr(what)));
    };
    refused("data_window has 0x0 pixels", [](FilmPicture& p) { p.data_window = {}; });
    refused("data_window", [](FilmPicture& p) { p.data_window = {1 << 30, 0, (1 << 30) + 13, 9}; });
    refused("width_px", [](FilmPicture& p) { p.width_px = 0; });
    refused("height_px", [](FilmPicture& p) { p.height_px = -1; });
    refused("\"samples\" has 13x8", [](FilmPicture& p) { p.counts[0].values = Image<std::uint32_t>(13, 8); });
    refused("two channels \"samples\"", [](FilmPicture& p) { p.floats[0].name = "samples"; });
    refused("0 characters", [](FilmPicture& p) { p.floats[0].name = ""; });
    refused("256 characters", [](FilmPicture& p) { p.floats[0].name = std::string(256, 'a'); });
    refused("named \"G\"", [](FilmPicture& p) { p.floats[0].name = "G"; });
    refused("named \"S0.400nm\"", [](FilmPicture& p) { p.floats[0].name = "S0.400nm"; });
    refused("centre_nm", [](FilmPicture& p) { p.spectral[0].centre_nm = 1000.0; });
    refused("width_nm", [](FilmPicture& p) { p.spectral[0].width_nm = -1.0; });
    refused("two channels \"S0.550,938nm\"", [](FilmPicture& p) { p.spectral[0].centre_nm = 550.9381; });
    EXPECT_EQ(files_in_folder(), 0u);
}

}  // namespace
}  // namespace emulsion
