// The scenes that come with the repository: each can be read without a warning and rendered without a loss, says what
// it is for, and keeps what its comment promises.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/text_file.h"
#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"
#include "spectrum/metamerism.h"
#include "spectrum/named_spectra.h"

namespace emulsion::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::filesystem::path folder() { return EMULSION_SOURCE_DIR "/scenes"; }

std::vector<std::string> every_scene() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder())) {
        if (entry.path().extension() == ".pbrt") names.push_back(entry.path().stem());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::filesystem::path file_of(const std::string& name) { return folder() / (name + ".pbrt"); }

TEST(BundledScenes, AreEightOrMoreAndSmall) {
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder())) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    EXPECT_GE(every_scene().size(), 8u);
    EXPECT_LT(bytes, 10u << 20);
}

class BundledScene : public ::testing::TestWithParam<std::string> {};

TEST_P(BundledScene, SaysWhatItIsFor) {
    const std::string text = read_text_file(file_of(GetParam()));
    EXPECT_THAT(text, StartsWith("# "));
    EXPECT_THAT(text, HasSubstr("# What it is for: "));
}

// At an eighth of its resolution, two samples a pixel.
TEST_P(BundledScene, RendersWithoutWarningsOrLosses) {
    Scene scene = read_scene(file_of(GetParam()));
    EXPECT_THAT(scene.warnings, IsEmpty());
    scene.film.width_px /= 8;
    scene.film.height_px /= 8;
    Film film(film_options(scene));
    const PreparedScene prepared(std::move(scene), 0);
    RenderProgress progress;
    render(prepared, {.samples_per_pixel = 2}, film, progress);
    EXPECT_EQ(film.dropped().count(), 0u);
    EXPECT_EQ(film.saturated_pixels(), 0);
    const Image<XYZ> picture = film.xyz_image();
    const auto pixels = picture.pixels();
    const double sum = std::accumulate(pixels.begin(), pixels.end(), 0.0, [](double total, const XYZ& pixel) {
        return total + static_cast<double>(pixel.y);
    });
    EXPECT_GT(sum, 0.0);
}

std::string name_of(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Every, BundledScene, ::testing::ValuesIn(every_scene()), name_of);

/// The paints of metamers.pbrt, pair after pair: all that are tabulated at 48 wavelengths.
std::vector<Spectrum> metameric_paints() {
    std::vector<Spectrum> paints;
    for (const Material& material : read_scene(file_of("metamers")).materials) {
        const auto* const diffuse = std::get_if<DiffuseMaterial>(&material);
        const auto* const spectrum = diffuse != nullptr ? std::get_if<Spectrum>(&diffuse->reflectance) : nullptr;
        const auto* const table = spectrum != nullptr ? std::get_if<PiecewiseLinearSpectrum>(spectrum) : nullptr;
        if (table != nullptr && table->value.size() == 48) paints.push_back(*spectrum);
    }
    return paints;
}

TEST(Metamers, MatchUnderD65AndSplitUnderA) {
    const std::vector<Spectrum> paints = metameric_paints();
    ASSERT_EQ(paints.size(), 6u);
    const LightAndObserver daylight = {*named_spectrum("stdillum-D65")}, tungsten = {*named_spectrum("stdillum-A")};
    LightAndObserver other_eyes = daylight;
    other_eyes.observer = cie_1964_10deg();
    for (std::size_t pair = 0; pair < paints.size(); pair += 2) {
        const Spectrum &a = paints[pair], &b = paints[pair + 1];
        EXPECT_LT(lab_difference(a, b, daylight, Cie76Difference{}), 0.005) << pair;
        EXPECT_GT(lab_difference(a, b, tungsten, Cie76Difference{}), 28.0) << pair;
        EXPECT_LT(lab_difference(a, b, tungsten, Cie76Difference{}), 36.0) << pair;
        EXPECT_GT(lab_difference(a, b, other_eyes, Cie76Difference{}), 1.0) << pair;
    }
}

}  // namespace
}  // namespace emulsion::testing
