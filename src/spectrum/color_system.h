#pragma once
// Colour systems: ways to write a colour as three or four numbers, each convertible to and from XYZ. A system's
// formula, its components with their ranges, its domain and its source are in its own header; docs/colour-systems.md
// lists all.
//
// XYZ is relative: Y = 1 for the white of the context. "Encoded" RGB (R'G'B') has gone through a transfer function,
// "linear" RGB is proportional to light.

#include <span>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/named_value.h"
#include "spectrum/cielab.h"
#include "spectrum/cieluv.h"
#include "spectrum/cmy.h"
#include "spectrum/cmyk.h"
#include "spectrum/color_context.h"
#include "spectrum/color_values.h"
#include "spectrum/hsl.h"
#include "spectrum/hsv.h"
#include "spectrum/ictcp_system.h"
#include "spectrum/ipt.h"
#include "spectrum/lms.h"
#include "spectrum/normalised_rgb.h"
#include "spectrum/oklab.h"
#include "spectrum/opponent.h"
#include "spectrum/rgb_systems.h"
#include "spectrum/uvw_system.h"
#include "spectrum/xyy.h"
#include "spectrum/ycbcr.h"
#include "spectrum/yiq.h"
#include "spectrum/yuv.h"

namespace emulsion {

/// All colour systems. Beside kName and kHelp (core/named_value.h) each has kComponents, and kDomain: the XYZ that go
/// there and back, in words. Outside its domain a system gives numbers that aren't finite, or forgets the chromaticity
/// of a colour without luminance, as its header says; nothing throws. NaN stays NaN.
using ColorSystem = std::variant<XyzSystem, XyySystem, LabSystem, LchAbSystem, LuvSystem, LchUvSystem, UvwSystem,
                                 LmsHpeSystem, LmsBradfordSystem, LmsCat02System, LmsCat16System, LmsCie2015System,
                                 OklabSystem, OklchSystem, IptSystem, IctcpSystem, LinearRgbSystem, NormalisedRgbSystem,
                                 OpponentSystem, EncodedRgbSystem, HsvSystem, HslSystem, CmySystem, CmykSystem,
                                 YuvSystem, YiqSystem, YcbcrBt601System, YcbcrBt601NarrowSystem, YcbcrBt709System,
                                 YcbcrBt709NarrowSystem, YcbcrBt2020System, YcbcrBt2020NarrowSystem>;

/// The white under which the colours of a system are seen: the white of the RGB space for RGB and what is made of it,
/// D65 (x 0.3127, y 0.329) for those defined for it, (1, 1, 1) for normalised RGB, that of the context for all others.
/// Y = 1. What adapts on the way from one system to another adapts between these.
[[nodiscard]] XYZd white_of(const ColorSystem& system, const ColorContext& context) noexcept;

/// Three components, or four.
[[nodiscard]] std::span<const ColorComponent> components_of(const ColorSystem& system) noexcept;

[[nodiscard]] ColorValues from_xyz(const ColorSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;

/// \throws std::invalid_argument unless the colour has as many components as the system.
[[nodiscard]] XYZd to_xyz(const ColorSystem& system, const ColorValues& color, const ColorContext& context);

}  // namespace emulsion
