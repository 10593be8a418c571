// Options of films and sensors as text.

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/film_options_text.h"
#include "film_state_fixture.h"
#include "filter_examples.h"

namespace emulsion {
namespace {

using emulsion::testing::every_film;
using ::testing::HasSubstr;

FilmOptions without_place_and_sensor(FilmOptions options) {
    options.width_px = FilmOptions{}.width_px;
    options.height_px = FilmOptions{}.height_px;
    options.crop = std::nullopt;
    options.sensor = {};
    return options;
}

TEST(FilmOptionsText, ComesBack) {
    std::vector<FilmOptions> all;
    for (const auto& film : every_film()) all.push_back(film.options);
    for (const Filter& filter : emulsion::testing::example_filters()) all.push_back({.filter = filter});
    all.push_back({.spectrum = SpectralBuckets{.count = 1, .min_nm = 100.0, .max_nm = 1000.0}});
    all.push_back({.spectrum = SpectralBuckets{.count = 64, .min_nm = 500.1, .max_nm = 501.3}});
    all.push_back({.spectrum = SpectralBuckets{.count = 7, .min_nm = 1000.0 / 3.0, .max_nm = 0.1 + 700.0}});
    all.push_back({.aux = {{"none", {"none"}}, {"-", {"-", "_"}}}});
    all.push_back({.firefly_control = LuminanceClamp{1e-38f}});
    for (const FilmOptions& options : all) {
        EXPECT_EQ(parse_film_options(to_text(options)), without_place_and_sensor(options)) << to_text(options);
    }
}

TEST(FilmOptionsText, NothingElseIsRead) {
    const std::string text = to_text(FilmOptions{});
    EXPECT_EQ(film_option_text(text, "variance"), "none");
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        return other.replace(other.find(from), from.size(), to);
    };
    for (const std::string& bad :
         {std::string(), text + " ", " " + text, text + " more=1", text + " variance=none",
          changed("variance=none", "variance=all"), changed("filter=box", "filter=bax"), changed("aux=none", "aux="),
          changed("aux=none", "aux=a"), changed("aux=none", "aux=a:"), changed("aux=none", "aux=depth"),
          changed("light-splats=no", "light-splats=maybe"), changed("spectrum=none", "spectrum=3"),
          changed("spectrum=none", "spectrum=3:4"), changed("spectrum=none", "spectrum=0:400-500"),
          changed("spectrum=none", "spectrum=3:500-400"), changed("filter-use=importance-sampled ", "")}) {
        EXPECT_THROW(static_cast<void>(parse_film_options(bad)), std::invalid_argument) << bad;
    }
}

TEST(FilmOptionsText, LayersThatAreKnownNeedNoComponents) {
    EXPECT_TRUE(parse_aux_layers("none").empty());
    const std::vector<AuxLayer> layers = {known_aux_layer("depth"), {"roughness", {"value"}}, {"normal", {"a", "b"}}};
    EXPECT_EQ(parse_aux_layers("depth,roughness:value,normal:a+b"), layers);
    for (const char* const bad : {"", "depth,", "roughness", "none,depth", "Depth"}) {
        EXPECT_THAT([&] { static_cast<void>(parse_aux_layers(bad)); },
                    ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr("expected auxiliary layers: name:comp")))
            << bad;
    }
}

TEST(SensorText, TellsSensorsApart) {
    std::set<std::string> texts;
    std::size_t sensors = 0;
    for (const auto& sensor : emulsion::testing::every_sensor()) {
        texts.insert(to_text(sensor.options));
        EXPECT_THAT(to_text(sensor.options), ::testing::Not(HasSubstr("\n")));
        ++sensors;
    }
    EXPECT_EQ(texts.size(), sensors);
    EXPECT_EQ(to_text(SensorOptions{}),
              "exposure-time=1 iso=100 observer=cie-1931-2deg white-balance=none camera=none");
    EXPECT_EQ(to_text(SensorOptions{.observer = "CIE 1931_2deg"}), to_text(SensorOptions{})) << "the same observer";
}

TEST(SensorText, SeesWhatACameraIs) {
    const SensorOptions options{.camera = CameraSensor{emulsion::testing::humps_camera(), {}}};
    std::set<std::string> texts = {to_text(options)};
    std::size_t kinds = 1;
    const auto expect_other = [&](auto change) {
        SensorOptions other = options;
        change(*other.camera);
        texts.insert(to_text(other));
        EXPECT_EQ(texts.size(), ++kinds) << to_text(other);
    };
    expect_other([](CameraSensor& c) { c.response.name = "other"; });
    expect_other([](CameraSensor& c) { c.response.lambda_nm.back() += 1e-9; });
    expect_other([](CameraSensor& c) { c.response.value[7].g *= 1.0000001; });
    const std::vector<Spectrum> lights = {ConstantSpectrum{1.0},
                                          PiecewiseLinearSpectrum{{400.0, 700.0}, {1.0, 2.0}},
                                          PiecewiseLinearSpectrum{{400.0, 700.0}, {1.0, 2.0}, Extrapolation::hold},
                                          BlackbodySpectrum{3200.0},
                                          BlackbodySpectrum{3200.0, BlackbodyUnit::radiance},
                                          SigmoidSpectrum{{1.0, 2.0, 3.0}},
                                          RgbIlluminantSpectrum{{}, {{400.0}, {1.0}}, 2.0},
                                          DenseSpectrum{400.0, 10.0, {1.0, 2.0}},
                                          DaylightSpectrum{5000.0},
                                          DaylightSpectrum{5000.0, DaylightWeights::exact},
                                          LineSpectrum{{{500.0, 1.0}}, {}},
                                          LineSpectrum{{}, {{500.0, 1.0, 1.0}}},
                                          product_of(ConstantSpectrum{1.0}, DaylightSpectrum{}, 2.0),
                                          product_of(ConstantSpectrum{2.0}, DaylightSpectrum{}, 2.0),
                                          sum_of(ConstantSpectrum{1.0}, DaylightSpectrum{}, 2.0, 3.0)};
    for (const Spectrum& light : lights) {
        expect_other([&](CameraSensor& c) { c.training.illuminant = light; });
        expect_other([&](CameraSensor& c) { c.training.target_illuminant = light; });
    }
    SensorOptions elsewhere = options;
    elsewhere.camera->response.name = "/some/folder/humps";
    EXPECT_EQ(to_text(elsewhere), to_text(options)) << "the same file in another folder";
}

}  // namespace
}  // namespace emulsion
