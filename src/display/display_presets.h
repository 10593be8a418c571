#pragma once
// Displays by their standards: primaries, white, the transfer function that they undo, and how bright they are.
//
// What the luminances are, and do: see display/display_light.h.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "display/display_light.h"
#include "spectrum/transfer_function.h"

namespace emulsion {

/// A preset with its luminances.
template <class Preset>
struct PresetDisplay {
    static constexpr std::string_view kName = Preset::kName, kHelp = Preset::kHelp;
    static constexpr std::string_view kSpace = Preset::kSpace;  ///< primaries and white: see spectrum/rgb_space.h
    static constexpr auto kTransfer = Preset::kTransfer;        ///< its own transfer function
    double peak_cdm2 = Preset::kDefaultPeak_cdm2;               ///< luminance of white
    double black_cdm2 = 0.0;                                    ///< its own at signal 0
    double flare_cdm2 = 0.0;                                    ///< of the room's light on it
    bool operator==(const PresetDisplay&) const = default;

    static constexpr std::array kParameters = {peak_parameter<PresetDisplay>(Preset::kPeakRange_cdm2),
                                               black_parameter<PresetDisplay>(), flare_parameter<PresetDisplay>()};
};

/// Of all presets whose standard doesn't say more.
struct AnyPeak {
    static constexpr ParameterRange kPeakRange_cdm2 = kPeak_cdm2;
};

/// Source: IEC 61966-2-1:1999, whose reference display has a white of 80 cd/m^2.
struct SrgbPreset : AnyPeak {
    static constexpr std::string_view kName = "srgb", kSpace = "sRGB";
    static constexpr std::string_view kHelp = "BT.709 primaries, D65 white";
    static constexpr double kDefaultPeak_cdm2 = 80.0;
    static constexpr SrgbTransfer kTransfer = {};
};

/// The primaries of SMPTE RP 431-2 with D65 and the curve of sRGB, as Apple defines it (SMPTE EG 432-1 has the
/// colours).
struct DisplayP3Preset : AnyPeak {
    static constexpr std::string_view kName = "display-p3", kSpace = "Display_P3";
    static constexpr std::string_view kHelp = "P3 primaries, D65 white, the curve of sRGB";
    static constexpr double kDefaultPeak_cdm2 = 80.0;
    static constexpr SrgbTransfer kTransfer = {};
};

/// Source: ITU-R BT.2020-2; BT.2035 for the luminance. Its display curve is that of BT.1886: what BT.2020 itself gives
/// is the camera's. In own_transfer() it has the display's black and peak.
struct Rec2020Preset : AnyPeak {
    static constexpr std::string_view kName = "rec2020", kSpace = "Rec2020";
    static constexpr std::string_view kHelp = "BT.2020 primaries, D65 white, the display curve of BT.1886";
    static constexpr double kDefaultPeak_cdm2 = 100.0;
    static constexpr Bt1886Transfer kTransfer = {};
};

/// Source: Adobe RGB (1998) Color Image Encoding, 2005-05, whose reference display has a white of 160 cd/m^2 (and a
/// black of 0.5557 cd/m^2, which is not our default).
struct AdobeRgbPreset : AnyPeak {
    static constexpr std::string_view kName = "adobe-rgb", kSpace = "Adobe_RGB_1998";
    static constexpr std::string_view kHelp = "Adobe RGB (1998), D65 white";
    static constexpr double kDefaultPeak_cdm2 = 160.0;
    static constexpr AdobeRgbTransfer kTransfer = {};
};

/// Source: SMPTE RP 431-2:2011, a cinema's projector: white (0.314, 0.351), 48 cd/m^2, a power of 2.6.
struct DciP3Preset : AnyPeak {
    static constexpr std::string_view kName = "dci-p3", kSpace = "DCI_P3";
    static constexpr std::string_view kHelp = "P3 primaries and the cinema's white, a power of 2.6";
    static constexpr double kDefaultPeak_cdm2 = 48.0;
    static constexpr GammaTransfer kTransfer = {2.6};
};

/// A cathode-ray tube with the phosphors of SMPTE RP 145-2004 (SMPTE C) and D65; a power of 2.5 is what tubes do by
/// their physics: Poynton, "The Rehabilitation of Gamma", Proc. SPIE 3299, 1998.
struct CrtPreset : AnyPeak {
    static constexpr std::string_view kName = "crt", kSpace = "SMPTE_C";
    static constexpr std::string_view kHelp = "SMPTE C phosphors, D65 white, a power of 2.5";
    static constexpr double kDefaultPeak_cdm2 = 100.0;
    static constexpr GammaTransfer kTransfer = {2.5};
};

/// BT.2020 primaries and PQ: ITU-R BT.2100-2. Codes above that of the peak aren't used.
struct Hdr10Preset : AnyPeak {
    static constexpr std::string_view kName = "hdr10", kSpace = "Rec2020";
    static constexpr std::string_view kHelp = "BT.2100 with PQ: codes are luminances";
    static constexpr double kDefaultPeak_cdm2 = 1000.0;
    static constexpr PqTransfer kTransfer = {};
};

/// BT.2020 primaries, HLG and its system gamma: ITU-R BT.2100-2, table 5, which gives the gamma for these peaks.
struct HlgPreset {
    static constexpr std::string_view kName = "hlg", kSpace = "Rec2020";
    static constexpr std::string_view kHelp = "BT.2100 with HLG, and the system gamma of the peak";
    static constexpr double kDefaultPeak_cdm2 = 1000.0;
    static constexpr ParameterRange kPeakRange_cdm2 = {400.0, 2000.0};
    static constexpr HlgTransfer kTransfer = {};
};

using SrgbDisplay = PresetDisplay<SrgbPreset>;
using DisplayP3 = PresetDisplay<DisplayP3Preset>;
using Rec2020Display = PresetDisplay<Rec2020Preset>;
using AdobeRgbDisplay = PresetDisplay<AdobeRgbPreset>;
using DciP3Display = PresetDisplay<DciP3Preset>;
using CrtDisplay = PresetDisplay<CrtPreset>;
using Hdr10Display = PresetDisplay<Hdr10Preset>;
using HlgDisplay = PresetDisplay<HlgPreset>;

}  // namespace emulsion
