// Agreement with Debian's pfstools, an implementation by others, where it is installed: packages pfstools and pfstmo.
//
// The number is the root mean square, over the pixels, of the difference of log10 luminances after the best common
// scale: 0 if all ratios of luminances in the picture are the same. A correlation forgives every exponent, and mean
// structural similarity hardly sees one: of drago and reinhard-global on one of these pictures they are 0.9995 and
// 0.99, and this is 0.07. What the curves of others come to is measured beside it, and must be past the tolerance.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "spectrum/cielab.h"
#include "structural_similarity.h"
#include "support/temporary_folder.h"
#include "three_pictures.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

/// The luminances of a picture as greys, so that operators that weight R, G and B otherwise see the same. None is 0.
Image<XYZ> as_greys(const Image<XYZ>& scene) {
    Image<XYZ> greys(scene.width(), scene.height());
    for (std::size_t i = 0; i < greys.pixels().size(); ++i) {
        greys.pixels()[i] = std::max(scene.pixels()[i].y, 1e-6f) * kWhite;
    }
    return greys;
}

bool is_installed(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

Image<XYZ> run_pfstools(const std::string& operator_command, const Image<XYZ>& scene) {
    const TemporaryFolder folder;
    ExrOptions options;
    options.space = "sRGB";
    (void)write_exr(folder.file("in.exr"), scene, {}, options);
    const std::string line =
        "cd " + folder.path().string() + " && pfsinexr in.exr | " + operator_command + " | pfsoutexr --float32 out.exr";
    if (std::system(line.c_str()) != 0) throw std::runtime_error(line);
    return read_exr(folder.file("out.exr")).xyz;
}

/// Under reinhard02, the largest luminance becomes white.
ToneMapping reinhard02(const SceneLuminance& luminance, const Image<XYZ>&) {
    const LuminanceStatistics& statistics = luminance.statistics();
    return {ReinhardGlobal{0.18f, static_cast<float>(0.18 * statistics.max_cdm2 / statistics.log_average_cdm2)}};
}

ToneMapping drago03(const SceneLuminance&, const Image<XYZ>&) { return {Drago{}}; }

/// durand02 has sigmas in pixels and natural logarithms, and takes the contrast of the base between its percentiles 1
/// and 99: ours is the one that gives the same exponent. Theirs stretches pictures of less contrast; ours doesn't.
ToneMapping durand02(const SceneLuminance& luminance, const Image<XYZ>& scene) {
    const double longer_side = std::max(scene.width(), scene.height());
    const BilateralAdaptation adaptation{static_cast<float>(8.0 / longer_side),
                                         static_cast<float>(0.4 / std::log(10.0))};
    const AdaptationLuminance base = adapt(adaptation, scene.view(), luminance, 1);
    std::vector<float> sorted(base.local.pixels().begin(), base.local.pixels().end());
    std::sort(sorted.begin(), sorted.end());
    const double base_range = std::log(sorted[sorted.size() * 99 / 100] / sorted[sorted.size() / 100]);
    const double range = std::log(luminance.robust_max_cdm2() / luminance.robust_min_cdm2());
    return {Durand{static_cast<float>(std::exp(3.0 * range / base_range))}, adaptation};
}

struct Peer {
    std::string program, arguments;
    ToneMapping (*ours)(const SceneLuminance&, const Image<XYZ>&);
    double tolerance;  ///< decades
};

std::ostream& operator<<(std::ostream& out, const Peer& peer) { return out << peer.program << peer.arguments; }

struct Agreement {
    double scale = 1.0;  ///< ours over theirs
    double rms_decades = 0.0;
    double similarity = 0.0;  ///< structural, of lightness, after that scale
};

Agreement agreement(const Image<XYZ>& ours, const Image<XYZ>& theirs) {
    const std::size_t count = ours.pixels().size();
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double difference = std::log10(ours.pixels()[i].y / theirs.pixels()[i].y);
        sum += difference;
        squares += difference * difference;
    }
    const double mean = sum / static_cast<double>(count);
    Agreement result;
    result.scale = std::pow(10.0, mean);
    result.rms_decades = std::sqrt(std::max(squares / static_cast<double>(count) - mean * mean, 0.0));
    Image<double> one(ours.width(), ours.height()), other(ours.width(), ours.height());
    for (std::size_t i = 0; i < count; ++i) {
        one.pixels()[i] = cie_lightness(std::min(double{ours.pixels()[i].y}, 1.0));
        other.pixels()[i] = cie_lightness(std::min(result.scale * theirs.pixels()[i].y, 1.0));
    }
    result.similarity = structural_similarity(one, other, 100.0);
    return result;
}

// Measured, on the picture that is worst: 1.2e-6, rounding only; 0.0030 with the sun in the picture, else 8e-5, as
// ours takes the robust maximum; 0.021, from how each approximates a bilateral filter and its percentiles. The nearest
// other curve is at 0.063, 0.069 and 0.081.
const std::vector<Peer> kPeers = {{"pfstmo_reinhard02", "", reinhard02, 1e-5},
                                  {"pfstmo_drago03", "", drago03, 0.0045},
                                  {"pfstmo_durand02", " -q -s 8 -r 0.4 -c 3", durand02, 0.03}};

class Pfstools : public testing::TestWithParam<Peer> {};

TEST_P(Pfstools, AgreesAndOtherCurvesDoNot) {
    const Peer& peer = GetParam();
    for (const std::string& program : {std::string("pfsinexr"), std::string("pfsoutexr"), peer.program}) {
        if (!is_installed(program)) GTEST_SKIP() << program << " is not installed (Debian: pfstools, pfstmo)";
    }
    for (const TestPicture& picture : three_pictures()) {
        const Image<XYZ> scene = as_greys(picture.scene);
        const SceneLuminance luminance(scene.view(), 1);
        const Image<XYZ> theirs = run_pfstools(peer.program + peer.arguments, scene);
        for (const Peer& curve : kPeers) {
            const ToneMapping mapping = curve.ours(luminance, scene);
            const Agreement found = agreement(tone_map(mapping, scene.view(), kWhite, 1).image, theirs);
            std::cout << picture.name << ", " << peer.program << ", " << to_text(mapping.mapper) << ": rms "
                      << found.rms_decades << " decades, similarity " << found.similarity << ", scale " << found.scale
                      << "\n";
            if (curve.program == peer.program) {
                EXPECT_LE(found.rms_decades, peer.tolerance);
            } else {
                EXPECT_GT(found.rms_decades, 2.0 * peer.tolerance);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Debian, Pfstools, testing::ValuesIn(kPeers),
                         [](const auto& instance) { return instance.param.program; });

}  // namespace
}  // namespace emulsion
