#pragma once
// How a film state file knows that it is whole: a checksum over all of its bytes, in a text attribute of its header,
// whose own digits are taken as '0'. OpenEXR checks headers, sizes and compressed chunks, but a flipped bit in a word
// of a sum would be news to it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <OpenEXR/ImfHeader.h>

#include "film/exr_header_reader.h"

namespace emulsion {

/// The version that is written, and the one that is read. Version 1 had other sums under filters with negative lobes,
/// and did not count faint samples. Where the checksum is and what it is of is the same in all.
inline constexpr const char* kFilmStateVersion = "2";

/// What marks a film state.
struct FilmStateMark {
    std::string version, checksum;        ///< as the header has them
    std::uint64_t checksum_position = 0;  ///< of the checksum's first digit in the file
};

/// Adds the version and room for the checksum to the header of one of the file's parts.
void add_mark(Imf::Header& header);

/// Reads to the end of the header; none if it is of no film state. \throws IoError if it is of no EXR.
[[nodiscard]] std::optional<FilmStateMark> find_mark(HeaderReader& file);

/// Of the whole file, in pieces; leaves the stream at its beginning. \throws IoError if it can't be read.
[[nodiscard]] std::string checksum_of(HeaderReader& file, const FilmStateMark& mark);

/// \throws IoError unless the file's bytes are those that were written, and its version is ours.
void require_whole(HeaderReader& file, const FilmStateMark& mark);

/// Puts the checksum into a file that has room for it. \throws IoError naming `named`.
void seal(const std::filesystem::path& file, const std::filesystem::path& named);

}  // namespace emulsion
