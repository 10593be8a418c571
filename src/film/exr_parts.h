#pragma once
// The one way in which EXR files are written: a list of parts, row by row, to a file that appears whole or not at all.

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>

#include "film/exr_compression.h"

namespace emulsion {

/// A part of scan lines. In a file of several, its header must have a name of its own, and the display window and (if
/// any) the chromaticities of the first.
struct ExrPart {
    Imf::Header header;
    /// How many rows are written at once.
    int rows_at_once = 1;
    /// The channels' values of `count` rows, the first of them `first` below the data window's top; they stay as they
    /// are until the next call. Types are those of the header: OpenEXR converts nothing in writing.
    std::function<Imf::FrameBuffer(int first, int count)> rows;
};

/// Sets the compression of a header.
void set_compression(Imf::Header& header, const ExrCompression& compression);

/// The name of a header's compression among ExrCompression.
[[nodiscard]] std::string_view compression_name(const Imf::Header& header);

/// Rows that are compressed together.
[[nodiscard]] int rows_per_chunk(const ExrCompression& compression) noexcept;

/// Where a channel's values are, for ExrPart::rows: `values` is that of the first of `rows` rows of the data window.
/// \param stride_bytes from a pixel to the next; rows follow one another without a gap
[[nodiscard]] Imf::Slice exr_slice(Imf::PixelType type, const void* values, std::size_t stride_bytes,
                                   const Imf::Header& header, int first, int count);

/// One part makes a plain file, several a multi-part one. `threads` as in ExrOptions. `finish`, if any, gets the whole
/// file under its temporary name, before it appears under its own.
/// \throws IoError if it cannot be written, to the last byte; a file of that name is then left as it was. Likewise
/// whatever `finish` throws.
void write_exr_parts(const std::filesystem::path& path, std::span<const ExrPart> parts, int threads,
                     const std::function<void(const std::filesystem::path&)>& finish = {});

}  // namespace emulsion
