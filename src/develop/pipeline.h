#pragma once
// Pipeline: the chain from scene-referred XYZ to code values, as one plain value.

#include <optional>
#include <string>
#include <string_view>

#include "display/code_value.h"
#include "display/display_rgb.h"
#include "display/dither.h"
#include "display/gamut_mapper.h"
#include "spectrum/transfer_function.h"
#include "tonemap/bloom.h"
#include "tonemap/tone_mapper.h"
#include "tonemap/vision.h"

namespace emulsion {

/// The stages, in their order. Text form, one key=value for each, separated by spaces:
///     bloom=none vision=none tonemap=reinhard-global:key=0.18,white=inf adaptation=own display=srgb gamut=clip
///     transfer=srgb bits=8 range=full dither=floyd-steinberg:scan=raster
struct Pipeline {
    Bloom bloom = NoBloom{};                     ///< "bloom"
    Vision vision = NoVision{};                  ///< "vision"
    ToneMapper tone_mapper = ReinhardGlobal{};   ///< "tonemap"
    std::optional<Adaptation> adaptation = {};   ///< "adaptation" luminance; none, "own": what the operator would take
    Display display = SrgbDisplay{};             ///< "display"
    GamutMapper gamut = GamutClip{};             ///< "gamut"
    TransferFunction transfer = SrgbTransfer{};  ///< "transfer"
    int bits = 8;                                ///< "bits" of a code value; 1 to 16
    CodeRange range = FullRange{};               ///< "range" of code values
    Dither dither = FloydSteinberg{};            ///< "dither"
    bool operator==(const Pipeline&) const = default;
};

/// All stages with all their parameters; parse_pipeline reads it back as the same value.
[[nodiscard]] std::string to_text(const Pipeline& pipeline);

/// Keys may come in any order; a stage that is left out has its default.
/// \throws std::invalid_argument for an unknown key, a key given twice, or a value that parse_named rejects; names what
/// was expected.
[[nodiscard]] Pipeline parse_pipeline(std::string_view text);

/// \throws std::invalid_argument naming stage, parameter, value and range, for the first that is out of its range.
void validate(const Pipeline& pipeline);

}  // namespace emulsion
