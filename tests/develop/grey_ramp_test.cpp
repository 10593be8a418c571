// Greys through every display and every transfer function, code by code, against the exact formulas.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "develop/develop.h"
#include "display/display_encoder.h"
#include "display/hlg_system.h"

namespace emulsion {
namespace {

/// By how much, relative, single precision and the matrix may be off in a wanted luminance. Where black and flare are
/// taken off it, what is left is off by as much of the whole: up to 40 codes of 16 bits next to black.
constexpr double kLightError = 7e-7;

/// Every display with its own transfer function and with all others, by their defaults; and some in a lit room.
std::vector<Pipeline> all_pipelines() {
    std::vector<Pipeline> all;
    for_each_alternative<Display>([&](const auto& display) {
        Pipeline pipeline{.display = display, .dither = NoDither{}};
        all.push_back(pipeline);
        auto lit = display;
        lit.black_cdm2 = 0.5, lit.flare_cdm2 = 2.0;
        pipeline.display = lit;
        all.push_back(pipeline);
        pipeline.display = display;
        for_each_alternative<TransferFunction>([&](const auto& transfer) {
            pipeline.transfer = transfer;
            all.push_back(pipeline);
        });
    });
    return all;
}

/// The codes of these wanted luminances (1 for white), which the whole chain after tone mapping makes.
Image<CodeRGB> shown(const Pipeline& pipeline, const std::vector<double>& wanted) {
    const XYZd white = white_xyz(pipeline.display);
    Image<XYZ> picture(static_cast<int>(wanted.size()), 1);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const XYZd p = wanted[i] * white;
        picture.pixels()[i] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }
    return develop_tone_mapped(picture, pipeline, 1).image;
}

/// Encoded value of a grey, by the formulas.
double exact_grey(const Pipeline& pipeline, double wanted) {
    const SignalScale scale = signal_scale(light_of(pipeline.display));
    const double signal = std::clamp(scale.gain * wanted - scale.pedestal, 0.0, 1.0);
    return encode_signal(pipeline.display, transfer_of(pipeline), {signal, signal, signal}).g;
}

/// The grey that has this encoded value; none if no grey has.
std::optional<double> grey_of(const Pipeline& pipeline, double encoded) {
    const DisplayLight light = light_of(pipeline.display);
    const TransferFunction transfer = transfer_of(pipeline);
    double signal = decode(transfer, encoded);
    std::optional<double> shown;
    if (std::holds_alternative<PqTransfer>(transfer)) {
        shown = signal * PqTransfer::kPeak_cdm2 / light.peak_cdm2;
    }
    if (std::holds_alternative<Bt1886Transfer>(transfer)) shown = signal;
    if (std::holds_alternative<HlgTransfer>(transfer) && std::holds_alternative<HlgDisplay>(pipeline.display)) {
        const double gamma = hlg_system_gamma(light.peak_cdm2);
        const double lift = std::sqrt(3.0 * std::pow(light.black_cdm2 / light.peak_cdm2, 1.0 / gamma));
        shown = std::pow(decode(transfer, (1.0 - lift) * encoded + lift), gamma);
    }
    // Of these three codes, the light of white with the display's black in it.
    if (shown) signal = (*shown * light.peak_cdm2 - light.black_cdm2) / (light.peak_cdm2 - light.black_cdm2);
    const bool in_gap = std::holds_alternative<Bt709Transfer>(transfer) && encoded > 0.081 && encoded < 0.08125;
    if (signal > 1.0 || signal < 0.0 || in_gap) return {};
    const SignalScale scale = signal_scale(light);
    return (signal + scale.pedestal) / scale.gain;
}

TEST(GreyRamp, EveryCodeComesOfItsOwnLight) {
    for (Pipeline pipeline : all_pipelines()) {
        const bool lit = light_of(pipeline.display).flare_cdm2 > 0.0;
        for (const int bits : {8, 16}) {
            // Next to the black of a lit display, 16 bits are finer than the light that single precision holds.
            if (lit && bits == 16) continue;
            pipeline.bits = bits;
            const int codes = (1 << bits) - 1;
            std::vector<double> wanted;
            std::vector<int> expected;
            for (int code = 0; code <= codes; ++code) {
                const std::optional<double> grey = grey_of(pipeline, static_cast<double>(code) / codes);
                if (!grey) continue;
                wanted.push_back(*grey);
                expected.push_back(code);
            }
            // PQ leaves those above the peak: half of all for 100 cd/m^2.
            ASSERT_GT(expected.size(), 0.4 * codes) << to_text(pipeline);
            const Image<CodeRGB> found = shown(pipeline, wanted);
            int wrong = 0;
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const CodeRGB& p = found.pixels()[i];
                wrong += p.r != expected[i] || p.g != expected[i] || p.b != expected[i] ? 1 : 0;
            }
            EXPECT_EQ(wrong, 0) << to_text(pipeline);
        }
    }
}

TEST(GreyRamp, EvenStepsOfLightHaveTheCodesOfTheFormula) {
    for (Pipeline pipeline : all_pipelines()) {
        for (const int bits : {8, 16}) {
            pipeline.bits = bits;
            const int codes = (1 << bits) - 1;
            std::vector<double> wanted;
            for (int i = 0; i <= codes; ++i) wanted.push_back(static_cast<double>(i) / codes);
            const Image<CodeRGB> found = shown(pipeline, wanted);
            const auto code_at = [&](double light, double codes_more) {
                const double exact = std::clamp(exact_grey(pipeline, light), 0.0, 1.0) * codes + codes_more;
                return static_cast<int>(std::floor(exact + 0.5));
            };
            int wrong = 0, undecided = 0;
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                // 0.01 of a 16-bit code of the fast path.
                const int least = code_at(wanted[i] * (1.0 - kLightError), -0.01 * codes / 65535.0);
                const int most = code_at(wanted[i] * (1.0 + kLightError), 0.01 * codes / 65535.0);
                const CodeRGB& p = found.pixels()[i];
                for (const int channel : {p.r, p.g, p.b}) wrong += channel < least || channel > most ? 1 : 0;
                undecided += least != most ? 1 : 0;
            }
            EXPECT_EQ(wrong, 0) << to_text(pipeline);
            EXPECT_LT(undecided, 0.1 * codes) << to_text(pipeline);
        }
    }
}

// A pipeline that nobody touched makes sRGB.
TEST(GreyRamp, DefaultsAreThoseOfSrgb) {
    Pipeline plain{.dither = NoDither{}},
        spelt{.display = SrgbDisplay{}, .transfer = SrgbTransfer{}, .dither = NoDither{}};
    std::vector<double> wanted;
    for (int i = 0; i <= 65535; ++i) wanted.push_back(i / 65535.0);
    EXPECT_EQ(shown(plain, wanted), shown(spelt, wanted));
}

}  // namespace
}  // namespace emulsion
