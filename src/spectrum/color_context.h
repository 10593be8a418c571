#pragma once
// What colours are relative to: the choices that a colour system leaves open. XYZ is relative here: Y = 1 for the
// white.

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/rgb_space.h"
#include "spectrum/transfer_function.h"

namespace emulsion {

/// A white (of CIELAB, CIELUV, U*V*W*, and the chromaticity of black), an RGB space, and the transfer function with
/// which its linear RGB is encoded. The three are independent of each other, and nothing is ever adapted: a context of
/// sRGB with the white of A has for RGB (1, 1, 1) the XYZ of D65, which isn't grey in its CIELAB.
class ColorContext {
  public:
    /// sRGB, its white D65, its transfer function.
    ColorContext();
    /// The white is that of the RGB space.
    /// \throws std::invalid_argument if the space has no matrix, its white isn't as below, or a parameter of the
    /// transfer function is out of its range.
    ColorContext(const RgbSpace& rgb, TransferFunction transfer);
    /// \throws std::invalid_argument also unless X, Y and Z of the white are finite and > 0, and Y = 1 (to 1e-9).
    ColorContext(const RgbSpace& rgb, TransferFunction transfer, const XYZd& white);

    [[nodiscard]] const XYZd& white() const noexcept { return white_; }
    [[nodiscard]] const RgbSpace& rgb() const noexcept { return rgb_; }
    [[nodiscard]] const TransferFunction& transfer() const noexcept { return transfer_; }

    [[nodiscard]] RGBd linear_from_xyz(const XYZd& xyz) const noexcept;
    [[nodiscard]] XYZd xyz_from_linear(const RGBd& linear) const noexcept;
    /// Also of negative RGB and above 1: see spectrum/transfer_function.h.
    [[nodiscard]] RGBd encoded_from_xyz(const XYZd& xyz) const noexcept;
    [[nodiscard]] XYZd xyz_from_encoded(const RGBd& encoded) const noexcept;

  private:
    XYZd white_;
    RgbSpace rgb_;
    TransferFunction transfer_;
    Matrix3 xyz_from_rgb_, rgb_from_xyz_;
};

}  // namespace emulsion
