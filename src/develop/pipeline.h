#pragma once
// Pipeline: the chain from scene-referred XYZ to code values, as one plain value.

#include <optional>
#include <string>
#include <string_view>

#include "display/code_value.h"
#include "display/display.h"
#include "display/dither.h"
#include "display/gamut_mapper.h"
#include "display/scene_white.h"
#include "spectrum/transfer_function.h"
#include "tonemap/bloom.h"
#include "tonemap/precision.h"
#include "tonemap/tone_mapper.h"
#include "tonemap/vision.h"

namespace emulsion {

/// In text forms and flags, of a stage that is left to what another has of its own.
inline constexpr std::string_view kOwnStage = "own";

/// The stages, in their order. Text form, one key=value for each, separated by spaces:
///     bloom=none vision=none tonemap=reinhard-global:key=0.18,white=inf adaptation=own precision=fast
///     scene-white=none display=srgb:peak=80,black=0,flare=0 gamut=clip transfer=own bits=8 range=full
///     dither=blue-noise:size=128
struct Pipeline {
    Bloom bloom = NoBloom{};                    ///< "bloom"
    Vision vision = NoVision{};                 ///< "vision"
    ToneMapper tone_mapper = ReinhardGlobal{};  ///< "tonemap"
    std::optional<Adaptation> adaptation = {};  ///< "adaptation" luminance; none, "own": what the operator would take
    Precision precision = FastPrecision{};      ///< "precision" of the stages up to here
    SceneWhite scene_white = AsItIs{};          ///< "scene-white", adapted to the display's
    Display display = SrgbDisplay{};            ///< "display"
    GamutMapper gamut = GamutClip{};            ///< "gamut"
    std::optional<TransferFunction> transfer = {};  ///< "transfer"; none, "own": what the display undoes
    int bits = 8;                                   ///< "bits" of a code value; 1 to 16
    CodeRange range = FullRange{};                  ///< "range" of code values
    Dither dither = BlueNoise{};                    ///< "dither"
    bool operator==(const Pipeline&) const = default;
};

/// The transfer function of the pipeline, if need be the display's own.
[[nodiscard]] TransferFunction transfer_of(const Pipeline& pipeline);

/// All stages with all their parameters; parse_pipeline reads it back as the same value.
[[nodiscard]] std::string to_text(const Pipeline& pipeline);

/// Keys may come in any order; a stage that is left out has its default.
/// \throws std::invalid_argument for an unknown key, a key given twice, a value that parse_named rejects, or a
/// pipeline that validate() rejects; names what was expected.
[[nodiscard]] Pipeline parse_pipeline(std::string_view text);

/// \throws std::invalid_argument naming stage, parameter, value and range, for the first that is out of its range; also
/// if parameters don't go together: primaries on one line, a white that no light has, too few bits for the range.
void validate(const Pipeline& pipeline);

}  // namespace emulsion
