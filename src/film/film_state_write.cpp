#include <array>
#include <string>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "film/exr_attributes.h"
#include "film/exr_layers.h"
#include "film/exr_parts.h"
#include "film/exr_picture_part.h"
#include "film/film_layers.h"
#include "film/film_state.h"
#include "film/film_state_checksum.h"
#include "film/film_state_fields.h"
#include "film/film_state_sums.h"

namespace emulsion {

namespace {

/// Where the picture has a lossy compression, the sums have the default.
ExrCompression lossless(const ExrCompression& compression) {
    return is_lossy(compression) ? ExrOptions{}.compression : compression;
}

Imf::Header sums_header(const FilmState& state, const Imf::Header& picture, const ExrCompression& compression) {
    Imf::Header header(picture.displayWindow(), picture.dataWindow());
    header.setName("sums");
    set_compression(header, lossless(compression));
    if (Imf::hasChromaticities(picture)) Imf::addChromaticities(header, Imf::chromaticities(picture));
    add_mark(header);
    const FilmStateFields fields = fields_of(state);
    for_each_state_field(fields, [&](const char* name, const auto& value) {
        header.insert(name, Imf::StringAttribute(attribute_text(value)));
    });
    for_each_sum_channel(state.contents, [&](const std::string& name, const std::byte*, std::size_t) {
        header.channels().insert(name, Imf::Channel(Imf::UINT));
    });
    return header;
}

/// All rows at once, from where they lie.
ExrPart sums_part(const FilmState& state, const Imf::Header& picture, const ExrCompression& compression) {
    const Imf::Header header = sums_header(state, picture, compression);
    const int height = header.dataWindow().max.y - header.dataWindow().min.y + 1;
    return {header, height, [&state, header](int first, int count) {
                Imf::FrameBuffer rows;
                for_each_sum_channel(state.contents,
                                     [&](const std::string& name, const std::byte* words, std::size_t stride) {
                                         rows.insert(name, exr_slice(Imf::UINT, words, stride, header, first, count));
                                     });
                return rows;
            }};
}

}  // namespace

ExrWriteResult write_film_state(const std::filesystem::path& path, const FilmState& state, const ExrOptions& options) {
    ExrOptions picture_options = options;
    picture_options.white_luminance_cdm2 = white_luminance_cdm2(state.options.sensor);
    validate(picture_options);
    const FilmSetup setup(state.options);
    require_size(state.contents, state.options);
    const FilmPicture picture = picture_of(state.contents, setup);
    const PictureView view = view_of(picture);
    validate(view);

    PicturePart writer(view, state.metadata, picture_options);
    std::array<ExrPart, 2> parts = {writer.part(), {}};
    parts[0].header.setName("picture");
    parts[1] = sums_part(state, parts[0].header, options.compression);
    write_exr_parts(path, parts, options.threads,
                    [&path](const std::filesystem::path& temporary) { seal(temporary, path); });
    return writer.result();
}

}  // namespace emulsion
