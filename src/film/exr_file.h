#pragma once
// Film files: scene-referred pictures in OpenEXR, with what made them in the header.
//
// Values are absolute: the header's whiteLuminance is the luminance in cd/m^2 that XYZ with Y = 1, or RGB (1, 1, 1),
// stands for. A film with an imaging ratio (exposure time * ISO / 100) stores luminance times that ratio, and a
// whiteLuminance of 1 / ratio; so exposure changes the numbers in the file, and reading gives the same cd/m^2.
// That holds for the picture. Layers are numbers: they are stored and read as they were handed over.
//
// Chromaticities are those of the three channels: (1, 0), (0, 1), (0, 0) with white (1/3, 1/3) for X Y Z; those of the
// space for R G B. adoptedNeutral is the white of the space for R G B. X Y Z have none: the white of their axes is no
// colour that anybody took for neutral, and a picture that is not developed has not chosen one.
//
// Spectral channels follow A. Fichet, R. Pacanowski, A. Wilkie, "An OpenEXR Layout for Spectral Images", JCGT 10(3),
// 2021: "S0.550,938nm", spectralLayoutVersion "1.0", emissiveUnits "W.m^-2.sr^-1" as that paper's own program and
// pbrt-v4 write it. A value is radiance per nanometre, the mean over the bucket, as pbrt-v4's; the layout's text for
// the units has no word for "per nm". Wavelengths are rounded to 0.001 nm in the names; "emulsion.spectralBuckets" has
// the exact centres and widths.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/exr_compression.h"
#include "film/film_picture.h"
#include "film/pixel_type.h"

namespace emulsion {

/// What the header says about the making of a picture. The attribute's name stands beside each field; all are strings.
struct FilmMetadata {
    std::int64_t samples_per_pixel = 0;  ///< taken of every pixel, at least; "emulsion.samplesPerPixel"
    std::uint64_t sample_count = 0;      ///< in all pixels; "emulsion.sampleCount"
    /// Samples kept out of the film, by kind (film/dropped_samples.h).
    std::uint64_t dropped_nan_count = 0;                 ///< "emulsion.droppedNanCount"
    std::uint64_t dropped_infinite_count = 0;            ///< "emulsion.droppedInfiniteCount"
    std::uint64_t dropped_negative_luminance_count = 0;  ///< "emulsion.droppedNegativeCount"
    /// Samples too faint for the film's sums (film/film_counts.h); "emulsion.faintCount"
    std::uint64_t faint_count = 0;
    std::uint64_t seed = 0;             ///< "emulsion.seed"
    std::string renderer_version = {};  ///< "emulsion.rendererVersion"
    std::string command_line = {};      ///< "emulsion.commandLine"
    std::string model = {};             ///< how light was carried, and why so; "emulsion.model"
    std::string sampling = {};          ///< FilmProvenance::sampling; empty: unknown; "emulsion.sampling"
    std::string pixels = {};            ///< half or float, and why so; empty: as asked for; "emulsion.pixels"
    std::string filter = {};            ///< "mitchell:..."; "emulsion.filter"
    std::string film = {};              ///< the film's other options; "emulsion.film"
    /// What was done against fireflies, and its measured bias; empty: nothing. "emulsion.fireflyControl"
    std::string firefly_control = {};
    bool operator==(const FilmMetadata&) const = default;
};

/// The name of X Y Z among those of the spaces.
inline constexpr const char* kXyzSpaceName = "XYZ";

/// What ExrOptions::space may be: "XYZ", and every RGB space of spectrum/rgb_space.h.
[[nodiscard]] std::vector<std::string> exr_space_names();

struct ExrOptions {
    /// Which three channels the file has: X Y Z, or linear R G B of a space of this name (core/name_key.h), with its
    /// primaries and white in single precision, as the header holds them.
    std::string space = kXyzSpaceName;
    /// Of the picture, the spectral channels and the layers; but layers named "depth" or "variance" (or "depth.Z", ...)
    /// are always float32: half has 11 bits for a depth, and a range too small for squares. Counts have 32-bit
    /// integers.
    PixelType pixel_type = PixelType::float32;
    ExrCompression compression = ZipCompression{};
    /// What Y = 1 of the XYZ handed over stands for: white_luminance_cdm2(SensorOptions) for pictures of a film.
    /// "whiteLuminance", in single precision; in [1e-30, 1e30].
    double white_luminance_cdm2 = 1.0;
    /// 0: one for each processor; no result depends on it. Threads beyond the first come from OpenEXR's pool, which all
    /// of the process shares: it is made to have as many if it has fewer, and never made smaller.
    int threads = 0;
    bool operator==(const ExrOptions&) const = default;
};

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const ExrOptions& options);

/// Channel values that a file could not hold as they were. Those of layers that are always float32 are held as they
/// are, and not counted: a depth may well be infinite. Fewer digits, in subnormal numbers too, are no such loss.
struct ExrWriteResult {
    std::int64_t too_high_count = 0;           ///< finite, above the largest of the pixel type: stored as that
    std::int64_t too_low_count = 0;            ///< finite, below minus the largest: stored as that
    std::int64_t vanished_positive_count = 0;  ///< above 0, and too small: stored as 0
    std::int64_t vanished_negative_count = 0;  ///< below 0, and too small: stored as -0
    std::int64_t non_finite_count = 0;         ///< NaN or infinite: stored as such
    ExrWriteResult& operator+=(const ExrWriteResult& other) noexcept;
    bool operator==(const ExrWriteResult&) const = default;
};

/// Writes a picture (Y in units of options.white_luminance_cdm2), as it is. The file appears whole or not at all.
/// \throws IoError if it cannot be written, to the last byte; a file of that name is then left as it was.
/// \throws std::invalid_argument for options out of their range; for a picture without pixels, with images or a data
/// window of another size than xyz, without a full frame, or with a wavelength out of its range; and for layers without
/// a name, with the same name as another channel, or with one of a picture's or a spectral channel.
ExrWriteResult write_exr(const std::filesystem::path& path, const FilmPicture& picture, const FilmMetadata& metadata,
                         const ExrOptions& options = {});
/// XYZ alone, which is the full frame.
ExrWriteResult write_exr(const std::filesystem::path& path, const Image<XYZ>& xyz, const FilmMetadata& metadata,
                         const ExrOptions& options = {});

/// The XYZ that read_exr() would give back from a file written with these options, bit for bit: for going on with the
/// picture as if it had been written and read. Y in cd/m^2.
/// \throws std::invalid_argument as write_exr, and for a lossy compression: only the file can tell what that did.
[[nodiscard]] Image<XYZ> as_stored(const Image<XYZ>& xyz, const ExrOptions& options);

/// Whether a reader wants more than the picture.
enum class ExrLayers { read, skip };

struct ExrReadOptions {
    ExrLayers layers = ExrLayers::read;
    int threads = 0;  ///< as in ExrOptions
    bool operator==(const ExrReadOptions&) const = default;
};

/// A picture that was read: xyz has Y in cd/m^2, the file's whiteLuminance worked in; layers are as in the file, sorted
/// by name, and spectral channels by wavelength; data_window and the full frame's size are those of the file, moved so
/// that its display window starts at (0, 0).
struct FilmImage : FilmPicture {
    double white_luminance_cdm2 = 1.0;  ///< of Y = 1 in the file; xyz over this are the numbers that it holds
    FilmMetadata metadata;              ///< a field that the file does not have keeps its default
    std::vector<std::string> notes;     ///< what was assumed or left out, one sentence each; empty for our own files
};

/// Reads a file of write_exr(), or any scan-line or tiled EXR with channels X Y Z or R G B of half or float: of several
/// parts, the first such. RGB goes to XYZ by the file's chromaticities. Other channels become layers. Assumed, and said
/// in the notes: Rec. 709 where there are no chromaticities; 1 cd/m^2 where there is no whiteLuminance. Left out, and
/// said: other parts, subsampled channels and, without layers, the channels of no layer that hold no counts.
/// \throws IoError in one line if the file is missing, a folder, not an EXR, deep, damaged, incomplete, or holds other
/// channels.
/// \throws IoError likewise for a film state of which any bit has changed.
/// \throws std::invalid_argument if threads < 0.
[[nodiscard]] FilmImage read_exr(const std::filesystem::path& path, const ExrReadOptions& options = {});

}  // namespace emulsion
