#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/named_value.h"
#include "core/parameters.h"
#include "core/row_blocks.h"
#include "film/exr_channels.h"
#include "film/exr_file.h"
#include "film/exr_layers.h"
#include "film/exr_parts.h"
#include "film/exr_picture_part.h"

namespace emulsion {

namespace {

ExrWriteResult write_picture(const std::filesystem::path& path, const PictureView& picture,
                             const FilmMetadata& metadata, const ExrOptions& options) {
    validate(picture);
    validate(options);
    PicturePart writer(picture, metadata, options);
    const ExrPart part = writer.part();
    write_exr_parts(path, {&part, 1}, options.threads);
    return writer.result();
}

}  // namespace

void validate(const ExrOptions& options) {
    static_cast<void>(space_as_stored(options.space));
    validate_named(options.compression, "EXR compression");
    check_range(options.white_luminance_cdm2, {1e-30, 1e30}, "EXR file: white_luminance_cdm2");
    check_range(options.threads, {0.0, kInfinity}, "EXR file: threads");
}

ExrWriteResult write_exr(const std::filesystem::path& path, const FilmPicture& picture, const FilmMetadata& metadata,
                         const ExrOptions& options) {
    return write_picture(path, view_of(picture), metadata, options);
}

ExrWriteResult write_exr(const std::filesystem::path& path, const Image<XYZ>& xyz, const FilmMetadata& metadata,
                         const ExrOptions& options) {
    return write_picture(path, view_of(xyz), metadata, options);
}

Image<XYZ> as_stored(const Image<XYZ>& xyz, const ExrOptions& options) {
    validate(view_of(xyz));
    validate(options);
    if (is_lossy(options.compression)) {
        throw std::invalid_argument("EXR file: compression is " + to_text(options.compression) +
                                    ", which is lossy: what it stores is known from the file alone");
    }
    const ChannelEncoder encoder(options);
    const ChannelDecoder decoder(space_as_stored(options.space),
                                 static_cast<double>(white_luminance_as_stored(options)));
    Image<XYZ> stored(xyz.width(), xyz.height());
    parallel_for_rows(xyz.width(), xyz.height(), options.threads, [&](int y) {
        ExrWriteResult ignored;
        std::transform(xyz.row(y).begin(), xyz.row(y).end(), stored.row(y).begin(),
                       [&](const XYZ& pixel) { return decoder.decode(encoder.encode(pixel, ignored)); });
    });
    return stored;
}

}  // namespace emulsion
