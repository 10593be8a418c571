#pragma once
// Tone mapping: from scene-referred XYZ, Y in cd/m^2, to display-relative XYZ, Y = 1 at display white. One scale for
// each pixel, so that its chromaticity stays. Values above 1 and outside the display's gamut are left to src/display.

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "core/named_value.h"
#include "tonemap/aces_fit.h"
#include "tonemap/adaptation.h"
#include "tonemap/agx.h"
#include "tonemap/contrast.h"
#include "tonemap/drago.h"
#include "tonemap/durand.h"
#include "tonemap/exposure.h"
#include "tonemap/fixed_white.h"
#include "tonemap/hable.h"
#include "tonemap/high_contrast.h"
#include "tonemap/histogram.h"
#include "tonemap/histogram_human.h"
#include "tonemap/khronos_neutral.h"
#include "tonemap/local_adaptation.h"
#include "tonemap/max_to_white.h"
#include "tonemap/operator_traits.h"
#include "tonemap/reinhard_global.h"
#include "tonemap/reinhard_local.h"
#include "tonemap/scene_luminance.h"
#include "tonemap/tone_reproduction.h"
#include "tonemap/tumblin_rushmeier.h"
#include "tonemap/zone.h"

namespace emulsion {

/// All operators; the first is the default. core/named_value.h prints, parses and lists them.
using ToneMapper = std::variant<ReinhardGlobal, MaxToWhite, FixedWhite, Exposure, ContrastScale, ZoneSystem,
                                HistogramAdjustment, HistogramHuman, LocalAdaptation, HighContrast, ReinhardLocal,
                                Durand, TumblinRushmeier, Drago, HableFilmic, AcesFit, AgX, KhronosNeutral>;

/// What the operator itself says: see operator_traits.h, own_adaptation() and prepare() of each.
[[nodiscard]] OperatorTraits traits_of(const ToneMapper& mapper) noexcept;
[[nodiscard]] Adaptation own_adaptation(const ToneMapper& mapper);
[[nodiscard]] ToneReproduction prepare(const ToneMapper& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

/// An operator, and what it is adapted to.
struct ToneMapping {
    ToneMapper mapper = ReinhardGlobal{};
    std::optional<Adaptation> adaptation = std::nullopt;  ///< none: the operator's own
    bool operator==(const ToneMapping&) const = default;
};

/// \throws std::invalid_argument naming operator, parameter, value and range, for the first that is out of its range.
void validate(const ToneMapping& mapping);

struct ToneMapResult {
    Image<XYZ> image;                ///< display-relative; every component finite, Y >= 0
    LuminanceStatistics statistics;  ///< of the scene: counts the bad pixels and says where the first is
};

/// Maps a whole picture. Bad pixels (see LuminanceStatistics) come out defined and do not change the others: nan and
/// negative ones black, infinite ones `display_white`. Components are held below 2^100 by scaling the pixel down. A
/// picture without positive pixels comes out black, except where it is infinite.
/// The result has the same bits for every number of threads (0: all).
/// \throws std::invalid_argument if a parameter is out of its range, the picture is empty, or threads < 0.
/// \param display_white XYZ of display white, Y = 1.
[[nodiscard]] ToneMapResult tone_map(const ToneMapping& mapping, ImageView<const XYZ> scene, const XYZ& display_white,
                                     int threads);

/// A mapping made ready for one picture, to be gone through once, whole or by the stretch together with later stages.
/// The same pixels, to the bit, as tone_map() makes.
class PreparedToneMapping {
  public:
    /// \param scene outlives this; its pixels stay as they are as long as this is asked for others
    /// \throws std::invalid_argument as tone_map()
    PreparedToneMapping(const ToneMapping& mapping, ImageView<const XYZ> scene, const XYZ& display_white, int threads);

    /// Maps `scene` as `other`, of the same size, is mapped: by the same tone curve, adapted to the same luminance. So
    /// that two pictures may be compared, and one that is brighter comes out brighter. Local adaptations are those of
    /// the scene's own pixels; so is everything if `other` has no positive pixel.
    /// \throws std::invalid_argument also if the sizes differ.
    [[nodiscard]] static PreparedToneMapping as_other(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                                      ImageView<const XYZ> other, const XYZ& display_white,
                                                      int threads);

    /// The twins of the two, tone_map_reference() and tone_map_reference_as_other(), rounded to single precision. All
    /// pixels are mapped here and now, on one thread, and held in memory. \throws std::invalid_argument likewise.
    [[nodiscard]] static PreparedToneMapping reference(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                                       const XYZ& display_white);
    [[nodiscard]] static PreparedToneMapping reference_as_other(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                                                ImageView<const XYZ> other, const XYZ& display_white);

    [[nodiscard]] const LuminanceStatistics& statistics() const noexcept { return statistics_; }

    /// Writes pixels of row y from column x0 on, as many as `display` takes. May be called on several threads at once.
    void operator()(int y, int x0, std::span<XYZ> display) const {
        map_(y, x0, scene_.row(y).subspan(static_cast<std::size_t>(x0), display.size()), display);
    }

  private:
    explicit PreparedToneMapping(ImageView<const XYZ> scene) : scene_(scene) {}
    void map_to_black(const XYZ& display_white);
    void hold(const Image<XYZd>& display);

    ImageView<const XYZ> scene_;
    LuminanceStatistics statistics_;
    MapStretch map_;
};

/// The same into pixels that exist: `display` has the size of `scene`, and may be the same pixels.
/// \throws std::invalid_argument as above, or if the sizes differ.
LuminanceStatistics tone_map_into(const ToneMapping& mapping, ImageView<const XYZ> scene, ImageView<XYZ> display,
                                  const XYZ& display_white, int threads);

struct CurvePoint {
    double luminance_cdm2 = 0.0;
    double display_luminance = 0.0;  ///< relative: 1 is display white
};

/// What the operator makes of the picture's luminances, from the least positive one to the largest in steps of a
/// sixteenth of an octave; where each pixel has an adaptation of its own, of large areas of that luminance. Empty if no
/// pixel is positive. \throws std::invalid_argument as above.
[[nodiscard]] std::vector<CurvePoint> tone_curve(const ToneMapping& mapping, ImageView<const XYZ> scene, int threads);

/// The double-precision twin, on one thread: the operator's functions for each pixel, and local adaptations as their
/// sources have them. Of operators under one adaptation for the picture, tone_map() is within 2e-4 of it, relative in
/// each component, down to 1e-37 absolute, and up to its limit of 2^100; where a curve has a corner, within 4e-3.
/// As colours on a display, on three pictures (tests/develop/operator_differences_test.cpp), CIEDE2000 is then at most
/// 0.001 on average and 0.01 anywhere; of operators under their own local adaptation, 0.1 on average and 2.5 anywhere.
/// Between a picture and the same turned or mirrored it is at most 0.01.
[[nodiscard]] Image<XYZd> tone_map_reference(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                             const XYZd& display_white);

/// The twin of PreparedToneMapping::as_other(). \throws std::invalid_argument as that.
[[nodiscard]] Image<XYZd> tone_map_reference_as_other(const ToneMapping& mapping, ImageView<const XYZ> scene,
                                                      ImageView<const XYZ> other, const XYZd& display_white);

}  // namespace emulsion
