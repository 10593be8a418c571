#pragma once
// What the headers of a film file, or of one that others wrote, say of its picture. What is assumed or left out goes
// into notes, one sentence each.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>

#include "film/exr_file.h"
#include "film/film_picture.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

/// X Y Z or R G B.
using ChannelNames = std::array<const char*, 3>;

/// The channels of the picture: X Y Z if the part has them, else R G B, if it has those.
[[nodiscard]] std::optional<ChannelNames> picture_channels(const Imf::ChannelList& channels);

/// The first part with a picture. \throws std::runtime_error if there is none.
[[nodiscard]] int choose_part(const Imf::MultiPartInputFile& file);

void note_other_parts(const Imf::MultiPartInputFile& file, int chosen, std::vector<std::string>& notes);

[[nodiscard]] bool is_subsampled(const Imf::Channel& channel);

/// \throws std::runtime_error if the channel is not in a form that we read.
void check_picture_channel(const std::string& name, const Imf::Channel& channel);
/// The same of each channel of the picture.
void check_picture_channels(const Imf::ChannelList& channels, const ChannelNames& names);

[[nodiscard]] RgbSpace space_of_chromaticities(const Imf::Chromaticities& chromaticities);
/// The space of R G B by the header's chromaticities; none for X Y Z, which need no telling.
[[nodiscard]] std::optional<RgbSpace> space_of(const Imf::Header& header, const ChannelNames& names,
                                               std::vector<std::string>& notes);

[[nodiscard]] double white_luminance_cdm2(const Imf::Header& header, std::vector<std::string>& notes);

/// Where the picture lies in a frame that starts at (0, 0).
void place_in_frame(const Imf::Header& header, FilmPicture& picture);

}  // namespace emulsion
