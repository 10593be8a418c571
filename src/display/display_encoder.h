#pragma once
// From the linear signal of a display (display/display_rgb.h), in its gamut, to encoded values in [0, 1].

#include <cstdint>
#include <optional>
#include <span>

#include "core/color.h"
#include "display/display.h"
#include "display/hlg_system.h"
#include "display/transfer_encoder.h"
#include "spectrum/transfer_function.h"

namespace emulsion {

/// The transfer function of each component; three of them take something else than the display's signal s:
///   PQ, on any display: the luminance shown, (black + s (peak - black)) / 10000 cd/m^2;
///   BT.1886, on any display: the luminance shown, over that of white, shown_share(). The display's own has its black
///     and peak, so that code 0 is its black. What a transfer function with a black of its own can't show is 0.
///   HLG, on the display "hlg": the light of the scene, by hlg_scene_light() of shown_share(), and the code from which
///     the display's lift, hlg_black_lift(), leads to it: what would be below 0 is 0. On other displays it takes s.
/// Double precision. \param display and \param transfer as validate() and validate_named() ask for
[[nodiscard]] RGBd encode_signal(const Display& display, const TransferFunction& transfer, const RGBd& signal);

/// The same for pictures, made ready once: with the tolerance of TransferEncoder, and that of HlgSceneLight before it;
/// on the display "hlg" within 2.5e-7.
class DisplayEncoder {
  public:
    /// \throws std::invalid_argument if display or transfer function aren't valid.
    DisplayEncoder(const Display& display, const TransferFunction& transfer);

    /// In place. Components in [0, 1]. \return how many pixels have no code: of HLG, see hlg_scene_light().
    [[nodiscard]] std::int64_t operator()(std::span<RGB> signal) const noexcept;

  private:
    std::optional<HlgSceneLight> scene_light_;
    float black_ = 0.0f, lift_ = 0.0f;  // with scene_light_: black / peak, and hlg_black_lift() of it
    TransferEncoder encoder_;
};

}  // namespace emulsion
