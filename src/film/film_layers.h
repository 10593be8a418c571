#pragma once
// From a film to the picture and the layers that its files hold.

#include "film/film.h"
#include "film/film_picture.h"

namespace emulsion {

/// XYZ and, as the film's options ask for them: "samples"; "variance.Y" (or .X .Y .Z) and "standard-error.Y" with a
/// FilmVariance; the spectral buckets (0 where no sample has reached them); auxiliary layers as "albedo.R". Data window
/// and frame are the film's bounds and its full frame.
/// "samples" is there whenever any of the others is.
/// \throws std::logic_error as BasicFilm::xyz_image.
[[nodiscard]] FilmPicture picture_of(const Film& film);

/// Of what a film of these options has gathered. Of the sensor only the imaging ratio counts.
[[nodiscard]] FilmPicture picture_of(const FilmContents<ExactSums>& contents, const FilmSetup& setup);

}  // namespace emulsion
