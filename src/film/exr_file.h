#pragma once
// Film files: scene-referred pictures in OpenEXR, with what made them in the header.
//
// Values are absolute: the header's whiteLuminance is the luminance in cd/m^2 that XYZ with Y = 1, or RGB (1, 1, 1),
// stands for. A film with an imaging ratio (exposure time * ISO / 100) stores luminance times that ratio, and a
// whiteLuminance of 1 / ratio; so exposure changes the numbers in the file, and reading gives the same cd/m^2.
// Chromaticities are those of the three channels: (1, 0), (0, 1), (0, 0) with white (1/3, 1/3) for X Y Z; those of
// Rec. 709 with D65 for R G B.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/pixel_type.h"

namespace emulsion {

/// What the header says about the making of a picture. The attribute's name and type stand beside each field.
struct FilmMetadata {
    std::int64_t samples_per_pixel = 0;      ///< the fewest of any pixel; "emulsion.samplesPerPixel", string
    std::uint64_t sample_count = 0;          ///< in all pixels; "emulsion.sampleCount", string
    std::uint64_t dropped_sample_count = 0;  ///< kept out of the film; "emulsion.droppedSampleCount", string
    std::uint64_t seed = 0;                  ///< "emulsion.seed", string
    std::string renderer_version;            ///< "emulsion.rendererVersion", string
    std::string command_line;                ///< "emulsion.commandLine", string
    bool operator==(const FilmMetadata&) const = default;
};

/// Which three channels a file holds: CIE X Y Z, or linear R G B with the primaries and white of Rec. 709 (= sRGB).
enum class ExrColor { xyz, rec709 };

/// Lossless both.
enum class ExrCompression { none, zip };

struct ExrOptions {
    ExrColor color = ExrColor::xyz;
    PixelType pixel_type = PixelType::float32;
    ExrCompression compression = ExrCompression::zip;
    /// What Y = 1 of the XYZ handed over stands for: white_luminance_cdm2(SensorOptions) for pictures of a film.
    /// "whiteLuminance", in single precision; in [1e-30, 1e30].
    double white_luminance_cdm2 = 1.0;
    bool operator==(const ExrOptions&) const = default;
};

/// What a file could not hold as it was; channel values, three to a pixel.
struct ExrWriteResult {
    std::int64_t clamped_count = 0;     ///< finite, but beyond the largest of the pixel type: stored as that
    std::int64_t non_finite_count = 0;  ///< NaN or infinite: stored as such
    bool operator==(const ExrWriteResult&) const = default;
};

/// Writes XYZ (Y in units of options.white_luminance_cdm2), as it is. The file appears whole or not at all.
/// \throws IoError if it cannot be written, to the last byte; a file of that name is then left as it was.
/// \throws std::invalid_argument for an image without pixels, and for a white luminance out of its range.
ExrWriteResult write_exr(const std::filesystem::path& path, const Image<XYZ>& xyz, const FilmMetadata& metadata,
                         const ExrOptions& options = {});

/// The image that read_exr() would give back from a file written with these options, bit for bit: for going on with the
/// picture as if it had been written and read. Y in cd/m^2.
/// \throws std::invalid_argument as write_exr.
[[nodiscard]] Image<XYZ> as_stored(const Image<XYZ>& xyz, const ExrOptions& options);

/// A picture that was read.
struct FilmImage {
    Image<XYZ> xyz;                     ///< the data window; Y in cd/m^2, the file's whiteLuminance worked in
    double white_luminance_cdm2 = 1.0;  ///< of Y = 1 in the file; xyz over this are the numbers that it holds
    FilmMetadata metadata;              ///< a field that the file does not have keeps its default
    PixelBounds data_window;            ///< as in the file
    std::vector<std::string> notes;     ///< what was assumed or left out, one sentence each; empty for our own files
};

/// Reads a file of write_exr(), or any single-part scan-line or tiled EXR with channels X Y Z or R G B of half or
/// float. RGB goes to XYZ by the file's chromaticities. Assumed, and said in the notes: Rec. 709 where there are none;
/// 1 cd/m^2 where there is no whiteLuminance. Other channels are left out, and said.
/// \throws IoError in one line if the file is missing, a folder, not an EXR, damaged, incomplete, or holds other
/// channels.
[[nodiscard]] FilmImage read_exr(const std::filesystem::path& path);

}  // namespace emulsion
