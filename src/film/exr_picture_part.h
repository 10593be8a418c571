#pragma once

#include <array>
#include <string>
#include <vector>

#include <Imath/half.h>

#include "film/exr_channels.h"
#include "film/exr_file.h"
#include "film/exr_layers.h"
#include "film/exr_parts.h"

namespace emulsion {

/// The part of a film file that holds its picture and layers. What the pixel type and the space leave as it is goes to
/// OpenEXR from where it lies; the rest is converted in bands of rows, so that no second picture is held in memory.
class PicturePart {
  public:
    /// Picture and options must be valid; the picture and this object must outlive the part.
    PicturePart(const PictureView& picture, const FilmMetadata& metadata, const ExrOptions& options);

    [[nodiscard]] ExrPart part();
    /// What the file could not hold of the rows written so far.
    [[nodiscard]] const ExrWriteResult& result() const noexcept { return result_; }

  private:
    [[nodiscard]] Imf::FrameBuffer rows(int first, int count);
    void insert_picture(int first, int count, Imf::FrameBuffer& rows);
    template <class Value>
    void encode_picture(int first, int count, std::vector<std::array<Value, 3>>& band);
    void insert_floats(const std::string& name, const Image<float>& values, int first, int count,
                       std::vector<half>& band, Imf::FrameBuffer& rows);

    PictureView picture_;
    ExrOptions options_;
    ChannelEncoder encoder_;
    ChannelRounder rounder_;
    Imf::Header header_;
    ExrWriteResult result_;
    // Of the rows at hand, where they are converted.
    std::vector<std::array<float, 3>> float_band_;
    std::vector<std::array<half, 3>> half_band_;
    std::vector<std::vector<half>> layer_bands_;
};

/// whiteLuminance as the header holds it.
[[nodiscard]] float white_luminance_as_stored(const ExrOptions& options);

}  // namespace emulsion
