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
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "core/error.h"
#include "film/exr_attributes.h"
#include "film/exr_channels.h"
#include "film/exr_file.h"
#include "film/exr_header_check.h"

namespace emulsion {

namespace {

struct ChannelChoice {
    ExrColor color = ExrColor::xyz;
    std::array<const char*, 3> names{};
};

/// X Y Z if the file has them, else R G B. \throws std::runtime_error if it has neither, or not in a form we read.
ChannelChoice choose_channels(const Imf::ChannelList& channels) {
    ChannelChoice choice{ExrColor::xyz, {"X", "Y", "Z"}};
    const auto has_all = [&] {
        return channels.findChannel(choice.names[0]) && channels.findChannel(choice.names[1]) &&
               channels.findChannel(choice.names[2]);
    };
    if (!has_all()) choice = {ExrColor::rec709, {"R", "G", "B"}};
    if (!has_all()) {
        std::string found;
        for (auto it = channels.begin(); it != channels.end(); ++it) found += std::string(" ") + it.name();
        throw std::runtime_error("has the channels" + found + ", expected X Y Z or R G B");
    }
    for (const char* name : choice.names) {
        const Imf::Channel& channel = channels[name];
        if (channel.type == Imf::UINT) {
            throw std::runtime_error(std::string("channel ") + name + " holds whole numbers, expected half or float");
        }
        if (channel.xSampling != 1 || channel.ySampling != 1) {
            throw std::runtime_error(std::string("channel ") + name + " is subsampled, expected one value a pixel");
        }
    }
    return choice;
}

void note_other_channels(const Imf::ChannelList& channels, const ChannelChoice& choice,
                         std::vector<std::string>& notes) {
    for (auto it = channels.begin(); it != channels.end(); ++it) {
        const std::string name = it.name();
        if (name == choice.names[0] || name == choice.names[1] || name == choice.names[2]) continue;
        notes.push_back("channel " + name + " was left out");
    }
}

/// The space of R G B by the header's chromaticities; none for X Y Z, which need no telling.
std::optional<RgbSpace> space_of(const Imf::Header& header, ExrColor color, std::vector<std::string>& notes) {
    if (color == ExrColor::xyz) return std::nullopt;
    if (!Imf::hasChromaticities(header)) {
        notes.emplace_back("no chromaticities: taken as Rec. 709 with the white D65");
        return rec709_as_stored();
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

FilmMetadata metadata_of(const Imf::Header& header, std::vector<std::string>& notes) {
    FilmMetadata metadata;
    for_each_metadata_field(metadata, [&](const char* name, auto& value) {
        const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
        if (!attribute || parse_attribute(attribute->value(), value)) return;
        notes.push_back(std::string(name) + " is \"" + attribute->value() + "\", expected a whole number: left out");
    });
    return metadata;
}

FilmImage read_checked(Imf::InputFile& file) {
    if (!file.isComplete()) throw std::runtime_error("is incomplete: some of its pixels were never written");
    const Imf::Header& header = file.header();
    const Imath::Box2i window = header.dataWindow();

    FilmImage image;
    const ChannelChoice choice = choose_channels(header.channels());
    note_other_channels(header.channels(), choice, image.notes);
    const auto space = space_of(header, choice.color, image.notes);
    image.white_luminance_cdm2 = white_luminance_cdm2(header, image.notes);
    const ChannelDecoder decoder(space, image.white_luminance_cdm2);
    image.metadata = metadata_of(header, image.notes);
    image.data_window = {window.min.x, window.min.y, window.max.x + 1, window.max.y + 1};
    image.xyz = Image<XYZ>(image.data_window.width(), image.data_window.height());

    // The channels go where X, Y and Z will be, and are decoded there.
    XYZ& first = image.xyz.pixels()[0];
    const std::array<float*, 3> places = {&first.x, &first.y, &first.z};
    Imf::FrameBuffer pixels;
    for (std::size_t i = 0; i < 3; ++i) {
        pixels.insert(choice.names[i], Imf::Slice::Make(Imf::FLOAT, places[i], window, sizeof(XYZ),
                                                        sizeof(XYZ) * static_cast<std::size_t>(image.xyz.width())));
    }
    file.setFrameBuffer(pixels);
    file.readPixels(window.min.y, window.max.y);
    for (XYZ& pixel : image.xyz.pixels()) pixel = decoder.decode({pixel.x, pixel.y, pixel.z});
    return image;
}

/// OpenEXR names the file in the middle of its messages, and may use several lines; ours has the name before it.
std::string plain_reason(std::string message, const std::string& path) {
    if (const auto at = message.find("\"" + path + "\". "); at != std::string::npos) {
        message = "cannot read: " + message.substr(at + path.size() + 4);
    }
    for (char& c : message) {
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    return message;
}

}  // namespace

FilmImage read_exr(const std::filesystem::path& path) {
    check_exr_header(path);
    try {
        Imf::InputFile file(path.c_str());
        return read_checked(file);
    } catch (const std::exception& error) {
        throw IoError(path, plain_reason(error.what(), path.string()));
    }
}

}  // namespace emulsion
