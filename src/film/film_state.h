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
    /// Of a film that was read: all but the camera and the white balance of its sensor, which such a film is past
    /// needing; sensor_text tells them.
    FilmOptions options;
    std::string sensor_text;  ///< to_text(SensorOptions) of the film's own sensor
    FilmContents<ExactSums> contents;
    FilmProvenance provenance;
    FilmMetadata metadata;  ///< as in the picture's header
};

/// A consistent copy of a film, even while others merge into it.
[[nodiscard]] FilmState state_of(const Film& film, FilmProvenance provenance, FilmMetadata metadata);

/// Writes the picture and the sums. The file appears whole or not at all, and has a checksum over all of its bytes.
/// options.white_luminance_cdm2 is taken from the film's sensor. \throws as write_exr.
ExrWriteResult write_film_state(const std::filesystem::path& path, const FilmState& state,
                                const ExrOptions& options = {});

/// \throws IoError in one line if the file is missing, no film state (a plain EXR among them), of another version, cut
/// off, or changed in any bit.
[[nodiscard]] FilmState read_film_state(const std::filesystem::path& path);

/// Whether the file says that it is a film state; its contents are not checked. \throws IoError if it can't be read.
[[nodiscard]] bool is_film_state(const std::filesystem::path& path);

/// Adds `other` to `state`: sums, counts, sample ranges.
/// \throws std::invalid_argument, before anything is added, if they do not belong together: size, crop window, filter
/// or other options, sensor, scene or sampling differ, or ranges of samples overlap; and if either has a partial round,
/// which would have to be rendered to its end first. The message says which, and both values.
void merge(FilmState& state, const FilmState& other);

}  // namespace emulsion
