#pragma once
// The picture as an eye on the spot would see it, for viewers who sit before a bright display. Scene-referred XYZ in
// cd/m^2 in and out, before tone mapping. Needs absolute luminances. How adaptation goes on in time is left out.

#include <array>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/image.h"
#include "core/parameters.h"

namespace emulsion {

/// The picture as it is.
struct NoVision {
    static constexpr std::string_view kName = "none";
    static constexpr std::string_view kHelp = "what is there, whether an eye could see it or not";
    bool operator==(const NoVision&) const = default;
};

/// In this order, as it happens in the eye: veiling glare (veiling_glare.h), loss of acuity (acuity.h), rods
/// (rod_vision.h). Source: Ward Larson, Rushmeier & Piatko 1997; those headers say what is different.
struct HumanVision {
    static constexpr std::string_view kName = "human";
    static constexpr std::string_view kHelp = "glare, blur in the dark, and the colours of the night; needs cd/m^2";
    float fov = 50.0f;    ///< angle that the picture's larger side takes, in degrees; in [1, 170]
    float glare = 1.0f;   ///< of the eye's share of scattered light; in [0, 1]
    float acuity = 1.0f;  ///< of the width of the blur by loss of acuity; in [0, 1]
    float rods = 1.0f;    ///< of the rods' share in mesopic and scotopic vision; in [0, 1]
    float blue = 1.0f;    ///< of the blue shift of what rods see; in [0, 1]
    bool operator==(const HumanVision&) const = default;

    static constexpr std::array kParameters = {
        Parameter<HumanVision>{
            "fov", &HumanVision::fov, {1.0, 170.0}, "degrees", "angle that the picture's larger side takes"},
        Parameter<HumanVision>{
            "glare", &HumanVision::glare, {0.0, 1.0}, "", "light scattered in the eye, of a typical eye's"},
        Parameter<HumanVision>{"acuity", &HumanVision::acuity, {0.0, 1.0}, "", "blur of what is dark, of a real eye's"},
        Parameter<HumanVision>{
            "rods", &HumanVision::rods, {0.0, 1.0}, "", "loss of colour in the dark, of a real eye's"},
        Parameter<HumanVision>{"blue", &HumanVision::blue, {0.0, 1.0}, "", "how bluish what rods see looks"}};
};

/// The first is the default. core/named_value.h prints, parses and lists them.
using Vision = std::variant<NoVision, HumanVision>;

/// Bad pixels (pixel_class.h) stay as they are, and others do not know of them: a negative one comes out of tone
/// mapping black, without the veil that lies over its neighbours, so that it can be seen where it is. A pixel of 1e30
/// cd/m^2 veils the whole picture, though: that is the method. Cost grows with the number of pixels only; memory
/// besides the result: one picture at most. The same bits for every number of threads (0: all). \throws
/// std::invalid_argument if a parameter is out of its range, the picture is empty, or threads < 0.
[[nodiscard]] Image<XYZ> see(const Vision& vision, ImageView<const XYZ> scene, int threads);

/// The double-precision twin.
[[nodiscard]] Image<XYZd> see_reference(const Vision& vision, ImageView<const XYZ> scene);

}  // namespace emulsion
