#pragma once
// From the linear signal of a display (display/display_rgb.h), in its gamut, to encoded values in [0, 1].

#include <optional>
#include <span>

#include "core/color.h"
#include "display/display.h"
#include "display/hlg_system.h"
#include "display/transfer_encoder.h"
#include "spectrum/transfer_function.h"

namespace emulsion {

/// The transfer function of each component; two of them take something else than the display's signal s:
///   PQ, on any display: the luminance shown, (black + s (peak - black)) / 10000 cd/m^2;
///   HLG, on the display "hlg": the light of the scene, by hlg_scene_light(). On other displays it takes s.
/// Double precision. \param display and \param transfer as validate() and validate_named() ask for
[[nodiscard]] RGBd encode_signal(const Display& display, const TransferFunction& transfer, const RGBd& signal);

/// The same for pictures, made ready once: with the tolerance of TransferEncoder, and that of HlgSceneLight before it.
class DisplayEncoder {
  public:
    /// \throws std::invalid_argument if display or transfer function aren't valid.
    DisplayEncoder(const Display& display, const TransferFunction& transfer);

    /// In place. Components in [0, 1].
    void operator()(std::span<RGB> signal) const noexcept;

  private:
    std::optional<HlgSceneLight> scene_light_;
    TransferEncoder encoder_;
};

}  // namespace emulsion
