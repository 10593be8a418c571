#include "display/icc_profile.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lcms2.h>

#include "core/random.h"
#include "spectrum/chromatic_adaptation.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using Profile = std::unique_ptr<void, decltype(&cmsCloseProfile)>;
using Transform = std::unique_ptr<void, decltype(&cmsDeleteTransform)>;

/// XYZ relative to ICC's D50 of encoded RGB, by Little CMS from the profile's bytes.
class OpenedProfile {
  public:
    explicit OpenedProfile(const std::string& icc)
        : profile_(cmsOpenProfileFromMem(icc.data(), static_cast<cmsUInt32Number>(icc.size())), &cmsCloseProfile),
          xyz_(cmsCreateXYZProfile(), &cmsCloseProfile),
          transform_(cmsCreateTransform(profile_.get(), TYPE_RGB_DBL, xyz_.get(), TYPE_XYZ_DBL,
                                        INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE),
                     &cmsDeleteTransform) {}

    [[nodiscard]] XYZd operator()(const RGBd& encoded) const {
        XYZd xyz;
        cmsDoTransform(transform_.get(), &encoded, &xyz, 1);
        return xyz;
    }
    [[nodiscard]] void* profile() const { return profile_.get(); }
    [[nodiscard]] bool opened() const { return transform_ != nullptr; }

  private:
    Profile profile_, xyz_;
    Transform transform_;
};

/// The same by our own matrices and transfer functions.
XYZd expected_xyz(const ColorEncoding& encoding, const RGBd& encoded) {
    const XYZd d50{0.9642, 1.0, 0.8249};  // ICC.1:2010, 7.2.16
    const Matrix3 adapt = adaptation_matrix(BradfordAdaptation{}, xyz_of(encoding.space.white), d50);
    const auto linear = [&](double v) { return decode(encoding.transfer, v); };
    const auto xyz =
        (adapt * xyz_from_rgb(encoding.space)) * std::array{linear(encoded.r), linear(encoded.g), linear(encoded.b)};
    return {xyz[0], xyz[1], xyz[2]};
}

std::vector<ColorEncoding> encodings() {
    std::vector<ColorEncoding> all;
    for (const char* space :
         {"sRGB", "Display_P3", "Rec2020", "DCI_P3", "ROMM_ProPhoto", "ACEScg_AP1", "ACES2065_1_AP0"}) {
        for_each_alternative<TransferFunction>([&](const auto& transfer) {
            if constexpr (!requires { transfer.kPeak_cdm2; }) {  // PQ
                if (transfer.kName != HlgTransfer::kName) all.push_back({rgb_space(space), transfer, FullRange{}});
            }
        });
        all.push_back({rgb_space(space), Bt1886Transfer{.black_cdm2 = 0.5, .white_cdm2 = 120.0}, FullRange{}});
        all.push_back({rgb_space(space), GammaTransfer{1.8}, FullRange{}});
    }
    return all;
}

// XYZ within 1e-3 is the task; rounding of the matrix and parameters to 2^-16 leaves 2e-4.
TEST(IccProfile, LittleCmsMapsColoursAsWeDo) {
    Pcg32 random(70);
    for (const ColorEncoding& encoding : encodings()) {
        const OpenedProfile opened(icc_profile(encoding));
        ASSERT_TRUE(opened.opened()) << encoding.space.name;
        const auto unit = [&] { return std::ldexp(static_cast<double>(random.next()), -32); };
        std::vector<RGBd> colors = {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.02, 0.03, 0.05}};
        for (int i = 0; i < 100; ++i) colors.push_back({unit(), unit(), unit()});
        for (const RGBd& color : colors) {
            const XYZd found = opened(color), expected = expected_xyz(encoding, color);
            const double error = std::max(
                {std::abs(found.x - expected.x), std::abs(found.y - expected.y), std::abs(found.z - expected.z)});
            ASSERT_LE(error, 2e-4) << encoding.space.name << ' ' << to_text(encoding.transfer) << ' ' << color.r << ' '
                                   << color.g << ' ' << color.b;
        }
    }
}

/// The numbers of a profile's parametric curve, in parts of 65536 (ICC.1:2010, 10.16).
std::vector<long> curve_numbers(const TransferFunction& transfer) {
    const std::string icc = icc_profile({rgb_space("sRGB"), transfer, FullRange{}});
    const auto integer = [&](std::size_t at, std::size_t bytes) {
        long value = 0;
        for (std::size_t i = 0; i < bytes; ++i) value = 256 * value + static_cast<unsigned char>(icc.at(at + i));
        return value;
    };
    const std::size_t curve = icc.find(std::string("para\0\0\0\0", 8));
    constexpr std::array<std::size_t, 5> kCounts = {1, 3, 4, 5, 7};  // by the type of function
    std::vector<long> numbers(kCounts.at(static_cast<std::size_t>(integer(curve + 8, 2))));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = integer(curve + 12 + 4 * i, 4);
    return numbers;
}

// The standards' constants, rounded to parts of 65536: a profile stays the same to the byte.
TEST(IccProfile, CurvesHaveTheNumbersOfTheirStandards) {
    const auto parts = [](const std::vector<double>& numbers) {
        std::vector<long> rounded;
        for (const double number : numbers) rounded.push_back(std::lround(number * 65536.0));
        return rounded;
    };
    EXPECT_EQ(curve_numbers(SrgbTransfer{}), parts({2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045}));
    EXPECT_EQ(curve_numbers(Bt709Transfer{}), parts({1 / 0.45, 1 / 1.099, 0.099 / 1.099, 1 / 4.5, 0.081}));
    EXPECT_EQ(curve_numbers(Bt2020Transfer{}), parts({1 / 0.45, 1 / 1.0993, 0.0993 / 1.0993, 1 / 4.5, 0.08145}));
    EXPECT_EQ(curve_numbers(ProPhotoTransfer{}), parts({1.8, 1.0, 0.0, 1 / 16.0, 1 / 32.0}));
    EXPECT_EQ(curve_numbers(AdobeRgbTransfer{}), parts({563 / 256.0}));
    EXPECT_EQ(curve_numbers(Bt1886Transfer{}), parts({2.4, 1.0, 0.0}));
    const double black = std::pow(0.5 / 120, 1 / 2.4);
    EXPECT_EQ(curve_numbers(Bt1886Transfer{0.5, 120.0}), parts({2.4, 1.0 - black, black}));
}

TEST(IccProfile, SaysWhatItIs) {
    const ColorEncoding encoding{rgb_space("Display_P3"), SrgbTransfer{}, FullRange{}};
    const std::string icc = icc_profile(encoding);
    EXPECT_LT(icc.size(), 1000u);
    EXPECT_EQ(icc.substr(24, 12), std::string("\x07\xd0\0\x01\0\x01\0\0\0\0\0\0", 12));
    EXPECT_EQ(icc, icc_profile(encoding));
    const OpenedProfile opened(icc);
    EXPECT_EQ(cmsGetDeviceClass(opened.profile()), cmsSigDisplayClass);
    EXPECT_EQ(cmsGetColorSpace(opened.profile()), cmsSigRgbData);
    EXPECT_EQ(cmsGetPCS(opened.profile()), cmsSigXYZData);
    std::string words(100, '\0');
    cmsGetProfileInfoASCII(opened.profile(), cmsInfoDescription, "en", "US", words.data(), 100);
    EXPECT_THAT(words, StartsWith("Emulsion: Display_P3, srgb"));
}

TEST(IccProfile, RefusesWhatItCannotSay) {
    for (const TransferFunction& transfer : {TransferFunction(PqTransfer{}), TransferFunction(HlgTransfer{})}) {
        EXPECT_THAT(
            [&] {
                (void)icc_profile({rgb_space("Rec2020"), transfer, FullRange{}});
            },
            testing::ThrowsMessage<std::invalid_argument>(HasSubstr("has no ICC profile")));
    }
}

}  // namespace
}  // namespace emulsion
