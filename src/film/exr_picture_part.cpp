#include "film/exr_picture_part.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <mutex>
#include <span>
#include <string>
#include <type_traits>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "core/parallel.h"
#include "core/row_blocks.h"
#include "film/exr_attributes.h"
#include "film/exr_metadata.h"

namespace emulsion {

namespace {

std::array<const char*, 3> channel_names(const std::optional<RgbSpace>& space) {
    if (space) return {"R", "G", "B"};
    return {"X", "Y", "Z"};
}

Imath::V2f point(const Chromaticity& c) { return {static_cast<float>(c.x), static_cast<float>(c.y)}; }

void add_color(const ExrOptions& options, Imf::Header& header) {
    const auto space = space_as_stored(options.space);
    if (space) {
        Imf::addChromaticities(header,
                               {point(space->red), point(space->green), point(space->blue), point(space->white)});
        Imf::addAdoptedNeutral(header, point(space->white));
    } else {
        Imf::addChromaticities(header, {{1.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, 0.0f}, {1.0f / 3.0f, 1.0f / 3.0f}});
    }
    Imf::addWhiteLuminance(header, white_luminance_as_stored(options));
}

Imf::PixelType stored_type(const ExrOptions& options) {
    return options.pixel_type == PixelType::half ? Imf::HALF : Imf::FLOAT;
}

void add_channels(const PictureView& picture, const ExrOptions& options, Imf::Header& header) {
    Imf::ChannelList& channels = header.channels();
    const Imf::PixelType type = stored_type(options);
    for (const char* name : channel_names(space_as_stored(options.space))) channels.insert(name, Imf::Channel(type));
    for (const FloatChannel& channel : picture.floats) {
        channels.insert(channel.name, Imf::Channel(is_always_float(channel.name) ? Imf::FLOAT : type));
    }
    for (const CountChannel& channel : picture.counts) channels.insert(channel.name, Imf::Channel(Imf::UINT));
    if (picture.spectral.empty()) return;
    for (const SpectralChannel& channel : picture.spectral) {
        channels.insert(spectral_channel_name(channel.centre_nm), Imf::Channel(type));
    }
    header.insert("spectralLayoutVersion", Imf::StringAttribute("1.0"));
    header.insert("emissiveUnits", Imf::StringAttribute("W.m^-2.sr^-1"));
    header.insert(kSpectralBucketsAttribute, Imf::StringAttribute(buckets_text(picture.spectral)));
}

Imf::Header make_header(const PictureView& picture, const FilmMetadata& metadata, const ExrOptions& options) {
    const PixelBounds& window = picture.data_window;
    Imf::Header header({{0, 0}, {picture.width_px - 1, picture.height_px - 1}},
                       {{window.x0, window.y0}, {window.x1 - 1, window.y1 - 1}});
    set_compression(header, options.compression);
    add_color(options, header);
    add_channels(picture, options, header);
    write_metadata(metadata, header);
    return header;
}

/// Calls body(y, result) for `count` rows from `first` on, in parallel, and adds up the results.
template <class Body>
void for_rows(const PictureView& picture, int first, int count, int threads, ExrWriteResult& total, const Body& body) {
    std::mutex mutex;  // guards total
    parallel_for_rows(picture.xyz.width(), count, threads, [&](int row) {
        ExrWriteResult result;
        body(first + row, result);
        const std::lock_guard lock(mutex);
        total += result;
    });
}

std::int64_t non_finite(std::span<const float> values) {
    constexpr std::uint32_t kExponent = 0x7f800000u;
    std::int64_t count = 0;
    for (const float value : values) count += (std::bit_cast<std::uint32_t>(value) & kExponent) == kExponent ? 1 : 0;
    return count;
}

std::int64_t non_finite(std::span<const XYZ> pixels) {
    static_assert(sizeof(XYZ) == 3 * sizeof(float));
    return non_finite(std::span<const float>(&pixels.front().x, 3 * pixels.size()));
}

}  // namespace

float white_luminance_as_stored(const ExrOptions& options) { return static_cast<float>(options.white_luminance_cdm2); }

PicturePart::PicturePart(const PictureView& picture, const FilmMetadata& metadata, const ExrOptions& options)
    : picture_(picture),
      options_(options),
      encoder_(options),
      rounder_(options.pixel_type),
      header_(make_header(picture, metadata, options)),
      layer_bands_(picture.floats.size() + picture.spectral.size()) {}

ExrPart PicturePart::part() {
    // Bands are long enough that all threads have chunks to compress; what needs no conversion goes in one.
    const bool in_place = options_.pixel_type == PixelType::float32 && !space_as_stored(options_.space);
    const int threads = options_.threads == 0 ? hardware_threads() : options_.threads;
    const int band = std::max(64, 2 * threads * rows_per_chunk(options_.compression));
    const int height = picture_.xyz.height();
    return {header_, in_place ? height : std::min(height, band),
            [this](int first, int count) { return rows(first, count); }};
}

Imf::FrameBuffer PicturePart::rows(int first, int count) {
    Imf::FrameBuffer rows;
    insert_picture(first, count, rows);
    std::size_t layer = 0;
    for (const FloatChannel& channel : picture_.floats) {
        insert_floats(channel.name, channel.values, first, count, layer_bands_[layer++], rows);
    }
    for (const SpectralChannel& channel : picture_.spectral) {
        insert_floats(spectral_channel_name(channel.centre_nm), channel.values, first, count, layer_bands_[layer++],
                      rows);
    }
    for (const CountChannel& channel : picture_.counts) {
        const auto& values = channel.values.row(first).front();
        rows.insert(channel.name, exr_slice(Imf::UINT, &values, sizeof(values), header_, first, count));
    }
    return rows;
}

void PicturePart::insert_picture(int first, int count, Imf::FrameBuffer& rows) {
    const auto space = space_as_stored(options_.space);
    const auto insert = [&](const auto* values) {  // three to a pixel
        for (const char* name : channel_names(space)) {
            rows.insert(name, exr_slice(stored_type(options_), values++, 3 * sizeof(*values), header_, first, count));
        }
    };
    if (options_.pixel_type == PixelType::half) {
        encode_picture(first, count, half_band_);
        insert(half_band_.front().data());
    } else if (space) {
        encode_picture(first, count, float_band_);
        insert(float_band_.front().data());
    } else {
        for_rows(picture_, first, count, options_.threads, result_,
                 [&](int y, ExrWriteResult& result) { result.non_finite_count = non_finite(picture_.xyz.row(y)); });
        static_assert(sizeof(XYZ) == 3 * sizeof(float));
        insert(&picture_.xyz.row(first).front().x);
    }
}

template <class Value>
void PicturePart::encode_picture(int first, int count, std::vector<std::array<Value, 3>>& band) {
    const auto width = static_cast<std::size_t>(picture_.xyz.width());
    band.resize(width * static_cast<std::size_t>(count));
    for_rows(picture_, first, count, options_.threads, result_, [&](int y, ExrWriteResult& result) {
        auto* to = &band[width * static_cast<std::size_t>(y - first)];
        for (const XYZ& xyz : picture_.xyz.row(y)) {
            const ChannelValues values = encoder_.encode(xyz, result);
            *to++ = {Value(values[0]), Value(values[1]), Value(values[2])};
        }
    });
}

void PicturePart::insert_floats(const std::string& name, const Image<float>& values, int first, int count,
                                std::vector<half>& band, Imf::FrameBuffer& rows) {
    const bool always_float = is_always_float(name);
    if (always_float || options_.pixel_type == PixelType::float32) {
        if (!always_float) {
            for_rows(picture_, first, count, options_.threads, result_,
                     [&](int y, ExrWriteResult& result) { result.non_finite_count = non_finite(values.row(y)); });
        }
        rows.insert(name, exr_slice(Imf::FLOAT, values.row(first).data(), sizeof(float), header_, first, count));
        return;
    }
    const auto width = static_cast<std::size_t>(values.width());
    band.resize(width * static_cast<std::size_t>(count));
    for_rows(picture_, first, count, options_.threads, result_, [&](int y, ExrWriteResult& result) {
        half* to = &band[width * static_cast<std::size_t>(y - first)];
        for (const float value : values.row(y)) *to++ = half(rounder_.round(static_cast<double>(value), result));
    });
    rows.insert(name, exr_slice(Imf::HALF, band.data(), sizeof(half), header_, first, count));
}

}  // namespace emulsion
