#include "film/exr_read_header.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "film/exr_attributes.h"
#include "film/exr_channels.h"

namespace emulsion {

namespace {

constexpr ChannelNames kXyzNames = {"X", "Y", "Z"};
constexpr ChannelNames kRgbNames = {"R", "G", "B"};

bool has_all(const Imf::ChannelList& channels, const ChannelNames& names) {
    return std::all_of(names.begin(), names.end(),
                       [&](const char* name) { return channels.findChannel(name) != nullptr; });
}

}  // namespace

std::optional<ChannelNames> picture_channels(const Imf::ChannelList& channels) {
    if (has_all(channels, kXyzNames)) return kXyzNames;
    if (has_all(channels, kRgbNames)) return kRgbNames;
    return std::nullopt;
}

int choose_part(const Imf::MultiPartInputFile& file) {
    std::string found;
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::ChannelList& channels = file.header(part).channels();
        if (picture_channels(channels)) return part;
        for (auto it = channels.begin(); it != channels.end(); ++it) found += std::string(" ") + it.name();
    }
    throw std::runtime_error("has the channels" + found + ", expected X Y Z or R G B");
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

bool is_subsampled(const Imf::Channel& channel) { return channel.xSampling != 1 || channel.ySampling != 1; }

void check_picture_channel(const std::string& name, const Imf::Channel& channel) {
    if (channel.type == Imf::UINT) {
        throw std::runtime_error("channel " + name + " holds whole numbers, expected half or float");
    }
    if (is_subsampled(channel)) {
        throw std::runtime_error("channel " + name + " is subsampled, expected one value a pixel");
    }
}

void check_picture_channels(const Imf::ChannelList& channels, const ChannelNames& names) {
    for (const char* name : names) check_picture_channel(name, channels[name]);
}

RgbSpace space_of_chromaticities(const Imf::Chromaticities& c) {
    const auto point = [](const Imath::V2f& v) {
        return Chromaticity{static_cast<double>(v.x), static_cast<double>(v.y)};
    };
    return RgbSpace{"chromaticities", point(c.red), point(c.green), point(c.blue), point(c.white)};
}

std::optional<RgbSpace> space_of(const Imf::Header& header, const ChannelNames& names,
                                 std::vector<std::string>& notes) {
    if (names == kXyzNames) return std::nullopt;
    if (Imf::hasChromaticities(header)) return space_of_chromaticities(Imf::chromaticities(header));
    notes.emplace_back("no chromaticities: taken as Rec. 709 with the white D65");
    return space_as_stored("Rec709");
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

void place_in_frame(const Imf::Header& header, FilmPicture& picture) {
    // OpenEXR keeps coordinates within 2^30, so that all fits.
    const Imath::Box2i& data = header.dataWindow();
    const Imath::Box2i& display = header.displayWindow();
    picture.data_window = {data.min.x - display.min.x, data.min.y - display.min.y, data.max.x + 1 - display.min.x,
                           data.max.y + 1 - display.min.y};
    picture.width_px = display.max.x - display.min.x + 1;
    picture.height_px = display.max.y - display.min.y + 1;
}

}  // namespace emulsion
