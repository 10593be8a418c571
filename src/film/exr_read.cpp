#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
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
#include "film/exr_threads.h"

namespace emulsion {

namespace {

using ChannelNames = std::array<const char*, 3>;
constexpr ChannelNames kXyzNames = {"X", "Y", "Z"};
constexpr ChannelNames kRgbNames = {"R", "G", "B"};

bool has_all(const Imf::ChannelList& channels, const ChannelNames& names) {
    return std::all_of(names.begin(), names.end(),
                       [&](const char* name) { return channels.findChannel(name) != nullptr; });
}

/// The channels of the picture: X Y Z if the part has them, else R G B, if it has those.
std::optional<ChannelNames> picture_channels(const Imf::ChannelList& channels) {
    if (has_all(channels, kXyzNames)) return kXyzNames;
    if (has_all(channels, kRgbNames)) return kRgbNames;
    return std::nullopt;
}

/// The first part with a picture. \throws std::runtime_error if there is none.
int choose_part(const Imf::MultiPartInputFile& file) {
    std::string found;
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::ChannelList& channels = file.header(part).channels();
        if (picture_channels(channels)) return part;
        for (auto it = channels.begin(); it != channels.end(); ++it) found += std::string(" ") + it.name();
    }
    throw std::runtime_error("has the channels" + found + ", expected X Y Z or R G B");
}

bool is_subsampled(const Imf::Channel& channel) { return channel.xSampling != 1 || channel.ySampling != 1; }

/// \throws std::runtime_error if a channel of the picture is not in a form that we read.
void check_picture_channels(const Imf::ChannelList& channels, const ChannelNames& names) {
    for (const char* name : names) {
        const Imf::Channel& channel = channels[name];
        if (channel.type == Imf::UINT) {
            throw std::runtime_error(std::string("channel ") + name + " holds whole numbers, expected half or float");
        }
        if (is_subsampled(channel)) {
            throw std::runtime_error(std::string("channel ") + name + " is subsampled, expected one value a pixel");
        }
    }
}

/// The space of R G B by the header's chromaticities; none for X Y Z, which need no telling.
std::optional<RgbSpace> space_of(const Imf::Header& header, const ChannelNames& names,
                                 std::vector<std::string>& notes) {
    if (names == kXyzNames) return std::nullopt;
    if (!Imf::hasChromaticities(header)) {
        notes.emplace_back("no chromaticities: taken as Rec. 709 with the white D65");
        return space_as_stored("Rec709");
    }
    const Imf::Chromaticities& c = Imf::chromaticities(header);
    const auto point = [](const Imath::V2f& v) {
        return Chromaticity{static_cast<double>(v.x), static_cast<double>(v.y)};
    };
    return RgbSpace{"chromaticities", point(c.red), point(c.green), point(c.blue), point(c.white)};
}

double white_luminance_cdm2(const Imf::Header& header, std::vector<std::string>& notes) {
    if (!Imf::hasWhiteLuminance(header)) {
        notes.emplace_back("no whiteLuminance: taken as 1 cd/m^2");
        return 1.0;
    }
    const auto value = static_cast<double>(Imf::whiteLuminance(header));
    if (std::isfinite(value) && value > 0.0) return value;
    notes.push_back("whiteLuminance is " + std::to_string(value) + ", no luminance: taken as 1 cd/m^2");
    return 1.0;
}

/// Where the picture lies in a frame that starts at (0, 0). OpenEXR keeps coordinates within 2^30, so that all fits.
void place_in_frame(const Imf::Header& header, FilmPicture& picture) {
    const Imath::Box2i& data = header.dataWindow();
    const Imath::Box2i& display = header.displayWindow();
    picture.data_window = {data.min.x - display.min.x, data.min.y - display.min.y, data.max.x + 1 - display.min.x,
                           data.max.y + 1 - display.min.y};
    picture.width_px = display.max.x - display.min.x + 1;
    picture.height_px = display.max.y - display.min.y + 1;
}

/// Makes room for the layers, or notes those that are left out.
void add_layers(const Imf::ChannelList& channels, const ChannelNames& picture_names, ExrLayers layers,
                FilmImage& image) {
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
            image.spectral.push_back({*wavelength_nm, 0.0, Image<float>(image.xyz.width(), image.xyz.height())});
        } else {
            image.floats.push_back({name, Image<float>(image.xyz.width(), image.xyz.height())});
        }
    }
}

/// Where OpenEXR is to put the channels: those of the picture where X, Y and Z will be.
Imf::FrameBuffer places_of(const Imf::Header& header, const ChannelNames& picture_names, FilmImage& image) {
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
    // By name again, in the order in which add_layers() met them.
    auto spectral = image.spectral.begin();
    for (auto it = header.channels().begin(); it != header.channels().end() && spectral != image.spectral.end(); ++it) {
        if (wavelength_of_channel(it.name()) != spectral->centre_nm || it.channel().type == Imf::UINT) continue;
        insert(it.name(), Imf::FLOAT, (spectral++)->values.pixels().data(), sizeof(float));
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

void note_other_parts(const Imf::MultiPartInputFile& file, int chosen, std::vector<std::string>& notes) {
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header& header = file.header(part);
        // The sums of a film state are no picture.
        if (part == chosen || header.findTypedAttribute<Imf::StringAttribute>(kFilmStateVersionAttribute)) continue;
        notes.push_back("part " + (header.hasName() ? "\"" + header.name() + "\"" : std::to_string(part)) +
                        " was left out");
    }
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
    add_layers(header.channels(), names, options.layers, image);
    const auto space = space_of(header, names, image.notes);
    image.white_luminance_cdm2 = white_luminance_cdm2(header, image.notes);
    const ChannelDecoder decoder(space, image.white_luminance_cdm2);
    image.metadata = read_metadata(header, image.notes);

    Imf::InputPart in(file, part);
    in.setFrameBuffer(places_of(header, names, image));
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
    try {
        constexpr bool kReconstructChunkTable = false;
        Imf::MultiPartInputFile file(path.c_str(), exr_threads, kReconstructChunkTable);
        return read_checked(file, options);
    } catch (const std::exception& error) {
        throw IoError(path, exr_reason(error, path));
    }
}

}  // namespace emulsion
