#pragma once
// What a film is to gather. All of it but the first two is optional, and costs nothing where it is left out.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/image.h"
#include "film/filter.h"
#include "film/firefly_control.h"
#include "film/sensor_options.h"
#include "film/spectral_buckets.h"

namespace emulsion {

/// How the reconstruction filter is applied to camera samples. The expected picture is the same.
enum class FilterUse {
    importance_sampled,  ///< a sample's place is drawn by the filter, and the sample belongs to one pixel
                         ///< (FilterSampler)
    splatted,            ///< places are uniform, and a sample goes into every pixel that the filter reaches
};

/// Sums of squares, for variances. 16 bytes a pixel for the luminance, 48 for X, Y and Z; under filters with negative
/// lobes 40 and 96.
enum class FilmVariance { none, luminance, xyz };

/// Further quantities of what a pixel shows, averaged by the filter: albedo, normal, depth, or any other by name.
struct AuxLayer {
    std::string name;                     ///< letters, digits, '-' and '_'; not "variance", "standard-error" or "S0"
    std::vector<std::string> components;  ///< likewise: "R", "G", "B"; 1 to 16, all different
    bool operator==(const AuxLayer&) const = default;
};

/// Layers under the names by which denoisers and compositors know them: {"albedo", R G B} (linear, reflectance),
/// {"normal", X Y Z} (unit vectors in world space), {"depth", Z} (along the ray, in scene units).
/// \throws std::invalid_argument for another name, listing these.
[[nodiscard]] AuxLayer known_aux_layer(const std::string& name);
[[nodiscard]] const std::vector<AuxLayer>& known_aux_layers();

struct FilmOptions {
    int width_px = 1280;                             ///< of the full frame; in [1, 65536]
    int height_px = 720;                             ///< of the full frame; in [1, 65536]
    SensorOptions sensor = {};                       ///< applied to spectral samples
    std::optional<PixelBounds> crop = std::nullopt;  ///< the pixels that there are; unset: the full frame
    Filter filter = BoxFilter{};  ///< draws places of samples, or spreads them; always spreads what light tracers send
    FilterUse filter_use = FilterUse::importance_sampled;
    bool light_splats = false;  ///< takes what light tracers send, beside camera samples
    FilmVariance variance = FilmVariance::none;
    std::optional<SpectralBuckets> spectrum = std::nullopt;
    std::vector<AuxLayer> aux = {};
    FireflyControl firefly_control = NoFireflyControl{};
    bool operator==(const FilmOptions&) const = default;
};

/// The pixels that the film has, in the coordinates of the full frame.
[[nodiscard]] PixelBounds bounds_of(const FilmOptions& options) noexcept;

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const FilmOptions& options);
/// The same for what a LuminanceClamp and the sensor's exposure are together; not part of validate(), since options
/// that are read from a text have their sensor elsewhere. A film's constructor asks both.
void validate_clamp(const FilmOptions& options);

/// All options but the size, the crop window and the sensor, for people and for files: "filter=box:x-radius=0.5,...
/// filter-use=importance-sampled variance=none ...".
[[nodiscard]] std::string to_text(const FilmOptions& options);

}  // namespace emulsion
