#pragma once
// Film state files (NAME.film.exr): everything that is needed to go on with a film. To any viewer one is an EXR of two
// parts whose first is the picture, as write_exr() writes it; the second has the exact sums as 32-bit words.

#include <filesystem>
#include <string>

#include "film/exr_file.h"
#include "film/film.h"
#include "film/film_provenance.h"

namespace emulsion {

/// A film that was written, or is to be.
struct FilmState {
    /// All but the camera and the white balance of the sensor, which sums are past needing; sensor_text tells them. So
    /// a film of these options shows the sums as they are, but must not be given more spectral samples: for that, make
    /// one of the options that the samples are for (require_same_film()).
    FilmOptions options;
    std::string sensor_text;  ///< to_text(SensorOptions) of the film's own sensor
    FilmContents<ExactSums> contents;
    FilmProvenance provenance;
    FilmMetadata metadata;  ///< as in the picture's header
    bool operator==(const FilmState&) const = default;
};

/// A consistent copy of a film, even while others merge into it. Of `run`, seed, renderer and command line are kept;
/// the rest of the metadata follows from the film (film/film_metadata.h).
[[nodiscard]] FilmState state_of(const Film& film, FilmProvenance provenance, FilmMetadata run);

/// Writes the picture and the sums. The file appears whole or not at all, and has a checksum over all of its bytes.
/// options.white_luminance_cdm2 is taken from the film's sensor. Sums are compressed as the picture is, if that loses
/// nothing, else by the default. \throws as write_exr, and std::logic_error as picture_of.
ExrWriteResult write_film_state(const std::filesystem::path& path, const FilmState& state,
                                const ExrOptions& options = {});

/// \throws IoError in one line if the file is missing, no film state (a plain EXR among them), of another version, cut
/// off, or changed in any bit.
[[nodiscard]] FilmState read_film_state(const std::filesystem::path& path);

/// Whether the file says that it is a film state; its contents are not checked. \throws IoError if it is no EXR.
[[nodiscard]] bool is_film_state(const std::filesystem::path& path);

/// That a film of these options, whose samples come from there, may go on from the state: size, crop window, filter and
/// other options, sensor, scene and sampling are the same. Which samples there are doesn't matter here.
/// \throws std::invalid_argument naming what differs, and both values.
void require_same_film(const FilmState& state, const FilmOptions& options, const FilmProvenance& provenance);

/// Adds `other` to `state`: sums, counts, sample ranges. The metadata's counts follow.
/// \throws std::invalid_argument, before anything is added, if they do not belong together: size, crop window, filter
/// or other options, sensor, scene or sampling differ, or ranges of samples overlap; and if either has a partial round,
/// which would have to be rendered to its end first. The message says which, and both values.
void merge(FilmState& state, const FilmState& other);

}  // namespace emulsion
