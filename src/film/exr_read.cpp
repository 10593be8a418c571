#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "core/error.h"
#include "core/row_blocks.h"
#include "film/exr_attributes.h"
#include "film/exr_channels.h"
#include "film/exr_file.h"
#include "film/exr_header_check.h"
#include "film/exr_layers.h"
#include "film/exr_messages.h"
#include "film/exr_metadata.h"
#include "film/exr_read_header.h"
#include "film/exr_threads.h"
#include "film/film_state_checksum.h"

namespace emulsion {

namespace {

/// Makes room for the layers, or notes those that are left out. Returns the names of the spectral ones.
std::vector<std::string> add_layers(const Imf::ChannelList& channels, const ChannelNames& picture_names,
                                    ExrLayers layers, FilmImage& image) {
    std::vector<std::string> spectral_names;
    for (auto it = channels.begin(); it != channels.end(); ++it) {
        const std::string name = it.name();
        if (std::find(picture_names.begin(), picture_names.end(), name) != picture_names.end()) continue;
        const bool is_count = it.channel().type == Imf::UINT;
        const bool of_no_layer = name.find('.') == std::string::npos;
        if (layers == ExrLayers::skip) {
            if (of_no_layer && !is_count) image.notes.push_back("channel " + name + " was left out");
        } else if (is_subsampled(it.channel())) {
            image.notes.push_back("channel " + name + " is subsampled and was left out");
        } else if (is_count) {
            image.counts.push_back({name, Image<std::uint32_t>(image.xyz.width(), image.xyz.height())});
        } else if (const auto wavelength_nm = wavelength_of_channel(name)) {
            spectral_names.push_back(name);
            image.spectral.push_back({*wavelength_nm, 0.0, Image<float>(image.xyz.width(), image.xyz.height())});
        } else {
            image.floats.push_back({name, Image<float>(image.xyz.width(), image.xyz.height())});
        }
    }
    return spectral_names;
}

/// Where OpenEXR is to put the channels: those of the picture where X, Y and Z will be.
Imf::FrameBuffer places_of(const Imf::Header& header, const ChannelNames& picture_names,
                           const std::vector<std::string>& spectral_names, FilmImage& image) {
    const Imath::Box2i& window = header.dataWindow();
    const auto width = static_cast<std::size_t>(image.xyz.width());
    Imf::FrameBuffer places;
    const auto insert = [&](const char* name, Imf::PixelType type, const void* values, std::size_t stride) {
        places.insert(name, Imf::Slice::Make(type, values, window, stride, stride * width));
    };
    XYZ& first = image.xyz.pixels().front();
    insert(picture_names[0], Imf::FLOAT, &first.x, sizeof(XYZ));
    insert(picture_names[1], Imf::FLOAT, &first.y, sizeof(XYZ));
    insert(picture_names[2], Imf::FLOAT, &first.z, sizeof(XYZ));
    for (FloatChannel& channel : image.floats) {
        insert(channel.name.c_str(), Imf::FLOAT, channel.values.pixels().data(), sizeof(float));
    }
    for (CountChannel& channel : image.counts) {
        insert(channel.name.c_str(), Imf::UINT, channel.values.pixels().data(), sizeof(std::uint32_t));
    }
    for (std::size_t i = 0; i < image.spectral.size(); ++i) {
        insert(spectral_names[i].c_str(), Imf::FLOAT, image.spectral[i].values.pixels().data(), sizeof(float));
    }
    return places;
}

/// By rising wavelength, with the exact buckets if the file tells them.
void order_spectral(const Imf::Header& header, std::vector<SpectralChannel>& spectral) {
    std::stable_sort(spectral.begin(), spectral.end(),
                     [](const SpectralChannel& a, const SpectralChannel& b) { return a.centre_nm < b.centre_nm; });
    const auto* buckets = header.findTypedAttribute<Imf::StringAttribute>(kSpectralBucketsAttribute);
    if (buckets) apply_buckets_text(buckets->value(), spectral);
}

FilmImage read_checked(Imf::MultiPartInputFile& file, const ExrReadOptions& options) {
    const int part = choose_part(file);
    if (!file.partComplete(part)) throw std::runtime_error("is incomplete: some of its pixels were never written");
    const Imf::Header& header = file.header(part);
    const ChannelNames names = *picture_channels(header.channels());
    check_picture_channels(header.channels(), names);

    FilmImage image;
    note_other_parts(file, part, image.notes);
    place_in_frame(header, image);
    image.xyz = Image<XYZ>(image.data_window.width(), image.data_window.height());
    const auto spectral_names = add_layers(header.channels(), names, options.layers, image);
    const auto space = space_of(header, names, image.notes);
    image.white_luminance_cdm2 = white_luminance_cdm2(header, image.notes);
    const ChannelDecoder decoder(space, image.white_luminance_cdm2);
    image.metadata = read_metadata(header, image.notes);

    Imf::InputPart in(file, part);
    in.setFrameBuffer(places_of(header, names, spectral_names, image));
    in.readPixels(header.dataWindow().min.y, header.dataWindow().max.y);
    order_spectral(header, image.spectral);
    if (decoder.is_identity()) return image;
    parallel_for_rows(image.xyz.width(), image.xyz.height(), options.threads, [&](int y) {
        for (XYZ& pixel : image.xyz.row(y)) pixel = decoder.decode({pixel.x, pixel.y, pixel.z});
    });
    return image;
}

}  // namespace

FilmImage read_exr(const std::filesystem::path& path, const ExrReadOptions& options) {
    const int exr_threads = use_exr_threads(options.threads);
    check_exr_header(path);
    HeaderReader bytes(path);
    if (const auto mark = find_mark(bytes)) require_whole(bytes, *mark);
    try {
        constexpr bool kReconstructChunkTable = false;
        Imf::MultiPartInputFile file(path.c_str(), exr_threads, kReconstructChunkTable);
        return read_checked(file, options);
    } catch (const std::exception& error) {
        throw IoError(path, exr_reason(error, path));
    }
}

}  // namespace emulsion
