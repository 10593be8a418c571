#include "display/icc_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <variant>
#include <vector>

#include <lcms2.h>

#include "core/named_value.h"

namespace emulsion {

namespace {

struct CurveDeleter {
    void operator()(cmsToneCurve* curve) const noexcept { cmsFreeToneCurve(curve); }
};
struct ProfileCloser {
    void operator()(void* profile) const noexcept { cmsCloseProfile(profile); }
};
struct TextDeleter {
    void operator()(cmsMLU* text) const noexcept { cmsMLUfree(text); }
};
using Curve = std::unique_ptr<cmsToneCurve, CurveDeleter>;
using Profile = std::unique_ptr<void, ProfileCloser>;
using Text = std::unique_ptr<cmsMLU, TextDeleter>;

/// Little CMS returns null where it fails. With values that were checked, only memory can be wanting.
template <class Pointer>
Pointer made(Pointer pointer) {
    if (pointer == nullptr) throw std::runtime_error("Little CMS could not make an ICC profile");
    return pointer;
}

// Little CMS's types of parametric curves are ICC's and 1.
constexpr int kPower = 1;             // v^g
constexpr int kPowerAboveOffset = 2;  // (a v + b)^g, 0 for v < -b / a
constexpr int kPowerAndToe = 4;       // (a v + b)^g for v >= d, c v below

Curve parametric(int type, const std::vector<double>& parameters) {
    return Curve(made(cmsBuildParametricToneCurve(nullptr, type, parameters.data())));
}

/// (1 + (v - 1) / scale)^exponent from `knee` on, v / slope below.
Curve power_and_toe(double exponent, double scale, double slope, double knee) {
    return parametric(kPowerAndToe, {exponent, 1.0 / scale, (scale - 1.0) / scale, 1.0 / slope, knee});
}

// The decoding of each transfer function, whose own header says the same.
Curve curve_of(const LinearTransfer& /*transfer*/) { return parametric(kPower, {1.0}); }
Curve curve_of(const GammaTransfer& transfer) { return parametric(kPower, {transfer.exponent}); }
Curve curve_of(const AdobeRgbTransfer& /*transfer*/) { return curve_of(AdobeRgbTransfer::kPower); }
Curve curve_of(const SrgbTransfer& /*transfer*/) {
    return power_and_toe(SrgbTransfer::kExponent, SrgbTransfer::kScale, SrgbTransfer::kSlope,
                         SrgbTransfer::kEncodedKnee);
}
Curve curve_of(const ProPhotoTransfer& /*transfer*/) {
    return power_and_toe(ProPhotoTransfer::kExponent, 1.0, ProPhotoTransfer::kSlope, ProPhotoTransfer::kEncodedKnee);
}
/// Of a camera.
template <class Transfer>
Curve curve_of_camera() {
    return power_and_toe(1.0 / Transfer::kExponent, Transfer::kScale, Transfer::kSlope,
                         Transfer::kSlope * Transfer::kLinearKnee);
}
Curve curve_of(const Bt709Transfer& /*transfer*/) { return curve_of_camera<Bt709Transfer>(); }
Curve curve_of(const Bt2020Transfer& /*transfer*/) { return curve_of_camera<Bt2020Transfer>(); }
Curve curve_of(const Bt1886Transfer& transfer) {
    constexpr double kExponent = Bt1886Transfer::kExponent;
    const double black = encode(GammaTransfer{kExponent}, transfer.black_cdm2 / transfer.white_cdm2);
    return parametric(kPowerAboveOffset, {kExponent, 1.0 - black, black});
}
template <class Hdr>
Curve no_curve() {
    throw std::invalid_argument("transfer " + std::string(Hdr::kName) + ": has no ICC profile of matrix and curves");
}
Curve curve_of(const PqTransfer& /*transfer*/) { return no_curve<PqTransfer>(); }
Curve curve_of(const HlgTransfer& /*transfer*/) { return no_curve<HlgTransfer>(); }
/// Any other.
template <class Transfer>
Curve curve_of(const Transfer& transfer) {
    constexpr std::size_t kPoints = 4096;
    std::vector<std::uint16_t> table(kPoints);
    for (std::size_t i = 0; i < kPoints; ++i) {
        const double linear = decode(transfer, static_cast<double>(i) / (kPoints - 1));
        table[i] = static_cast<std::uint16_t>(std::lround(std::clamp(linear, 0.0, 1.0) * 65535.0));
    }
    return Curve(made(cmsBuildTabulatedToneCurve16(nullptr, kPoints, table.data())));
}

cmsCIExyY point(const Chromaticity& chromaticity) { return {chromaticity.x, chromaticity.y, 1.0}; }

void describe(void* profile, const ColorEncoding& encoding) {
    const Text description(made(cmsMLUalloc(nullptr, 1)));
    const std::string words = "Emulsion: " + encoding.space.name + ", " + to_text(encoding.transfer);
    if (cmsMLUsetASCII(description.get(), "en", "US", words.c_str()) == 0 ||
        cmsWriteTag(profile, cmsSigProfileDescriptionTag, description.get()) == 0) {
        made<void*>(nullptr);
    }
}

std::string bytes_of(void* profile) {
    cmsUInt32Number size = 0;
    if (cmsSaveProfileToMem(profile, nullptr, &size) == 0) made<void*>(nullptr);
    std::string bytes(size, '\0');
    if (cmsSaveProfileToMem(profile, bytes.data(), &size) == 0) made<void*>(nullptr);
    return bytes;
}

/// In the place of the time of making: the first moment of 2000, six numbers of 16 bits.
void fix_date(std::string& bytes) {
    constexpr std::string_view kDate("\x07\xd0\0\x01\0\x01\0\0\0\0\0\0", 12);
    constexpr std::size_t kDateAt = 24;
    bytes.replace(kDateAt, kDate.size(), kDate);
}

}  // namespace

std::string icc_profile(const ColorEncoding& encoding) {
    (void)rgb_from_xyz(encoding.space);  // that there is a matrix
    const Curve curve = std::visit([](const auto& transfer) { return curve_of(transfer); }, encoding.transfer);
    const std::array<cmsToneCurve*, 3> curves = {curve.get(), curve.get(), curve.get()};
    const cmsCIExyY white = point(encoding.space.white);
    const cmsCIExyYTRIPLE primaries = {point(encoding.space.red), point(encoding.space.green),
                                       point(encoding.space.blue)};
    const Profile profile(cmsCreateRGBProfile(&white, &primaries, curves.data()));
    if (profile == nullptr) {
        throw std::invalid_argument("ICC profile of " + encoding.space.name +
                                    ": primaries and white have no matrix to D50");
    }
    describe(profile.get(), encoding);
    std::string bytes = bytes_of(profile.get());
    fix_date(bytes);
    return bytes;
}

}  // namespace emulsion
