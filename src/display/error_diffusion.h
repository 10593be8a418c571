#pragma once
// Error diffusion.
//
// Pixels are rounded one after the other, and the error of each is handed to neighbours that are not yet rounded, by
// the weights of a kernel (display/diffusion_kernel.h). Channels are independent. Errors are differences of encoded
// values, which keeps the visibility of steps even; the mean of the *encoded* picture is kept, not that of its light.
//
// Errors are whole units (display/code_units.h), and are split without remainder. At the border, the shares of pixels
// outside of the picture go to those inside, in proportion to their weights: in the last row all goes ahead. Only the
// error of the last pixel is lost. It is below one code unless pixels there are so near to 0 or 1 that no code is left
// to make the error good. But for that loss the sum of the codes is exactly that of the values, each rounded to a unit.
// Atkinson's kernel hands on 3/4 of each error and loses the rest on purpose.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "display/code_value.h"
#include "display/component_rows.h"
#include "display/encoded_source.h"

namespace emulsion {

/// Orders of the pixels. Raster: every row from the left. Serpentine: every other row from the right, with the kernel
/// mirrored. Hilbert: along display/hilbert_curve.h, with the kernel turned to where the curve goes, its lower part on
/// both sides, and with those of its pixels that are not yet rounded; the next pixel on the curve gets what the others
/// leave. Raster is the only one to use more than one thread, and Hilbert takes 33 bytes of memory a pixel.
inline constexpr int kRasterScan = 0, kSerpentineScan = 1, kHilbertScan = 2;
inline constexpr std::array kScanOrders = {ParameterWord{"raster", kRasterScan},
                                           ParameterWord{"serpentine", kSerpentineScan},
                                           ParameterWord{"hilbert", kHilbertScan}};

/// The parameter of all kernels.
template <class T>
[[nodiscard]] constexpr Parameter<T> scan_parameter() noexcept {
    return {"scan", &T::scan, {kRasterScan, kHilbertScan}, "", "order of the pixels", {}, kScanOrders};
}

struct FloydSteinberg {
    static constexpr std::string_view kName = "floyd-steinberg";
    static constexpr std::string_view kHelp = "error diffusion to 4 neighbours, in encoded values";
    int scan = kRasterScan;  ///< one of kScanOrders; so for all kernels
    bool operator==(const FloydSteinberg&) const = default;
    static constexpr std::array kParameters = {scan_parameter<FloydSteinberg>()};
};

struct Jarvis {
    static constexpr std::string_view kName = "jarvis";
    static constexpr std::string_view kHelp = "error diffusion of Jarvis, Judice and Ninke to 12 neighbours; sharpens";
    int scan = kRasterScan;
    bool operator==(const Jarvis&) const = default;
    static constexpr std::array kParameters = {scan_parameter<Jarvis>()};
};

struct Stucki {
    static constexpr std::string_view kName = "stucki";
    static constexpr std::string_view kHelp = "error diffusion of Stucki to 12 neighbours; sharpens";
    int scan = kRasterScan;
    bool operator==(const Stucki&) const = default;
    static constexpr std::array kParameters = {scan_parameter<Stucki>()};
};

struct Sierra {
    static constexpr std::string_view kName = "sierra";
    static constexpr std::string_view kHelp = "error diffusion of Sierra to 10 neighbours";
    int scan = kRasterScan;
    bool operator==(const Sierra&) const = default;
    static constexpr std::array kParameters = {scan_parameter<Sierra>()};
};

struct Atkinson {
    static constexpr std::string_view kName = "atkinson";
    static constexpr std::string_view kHelp =
        "error diffusion of 3/4 of the error; more contrast, the mean is not kept";
    int scan = kRasterScan;
    bool operator==(const Atkinson&) const = default;
    static constexpr std::array kParameters = {scan_parameter<Atkinson>()};
};

/// As quantize() in display/dither.h.
void quantize(const FloydSteinberg& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);
void quantize(const Jarvis& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);
void quantize(const Stucki& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);
void quantize(const Sierra& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);
void quantize(const Atkinson& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads);

}  // namespace emulsion
