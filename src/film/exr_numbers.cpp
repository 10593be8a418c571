#include "film/exr_numbers.h"

#include <exception>
#include <stdexcept>
#include <string>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include "core/error.h"
#include "film/exr_header_check.h"
#include "film/exr_messages.h"
#include "film/exr_read_header.h"
#include "film/exr_threads.h"

namespace emulsion {

namespace {

/// Which part, and which of its channels.
struct Choice {
    int part = 0;
    std::vector<std::string> names;
};

Choice choose(const Imf::MultiPartInputFile& file) {
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::ChannelList& channels = file.header(part).channels();
        const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
        if (!has("R") || !has("G") || !has("B")) continue;
        Choice choice{part, {"R", "G", "B"}};
        if (has("A")) choice.names.emplace_back("A");
        return choice;
    }
    const Imf::ChannelList& channels = file.header(0).channels();
    const bool is_one = channels.begin() != channels.end() && ++channels.begin() == channels.end();
    return is_one ? Choice{0, {channels.begin().name()}} : Choice{};
}

ExrNumbers read_checked(Imf::MultiPartInputFile& file) {
    const Choice choice = choose(file);
    if (!file.partComplete(choice.part)) {
        throw std::runtime_error("is incomplete: some of its pixels were never written");
    }
    const Imf::Header& header = file.header(choice.part);
    const Imath::Box2i& window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;

    ExrNumbers numbers;
    if (Imf::hasChromaticities(header)) numbers.space = space_of_chromaticities(Imf::chromaticities(header));
    for (const std::string& name : choice.names) {
        check_picture_channel(name, header.channels()[name.c_str()]);
        numbers.channels.push_back({name, Image<float>(width, height)});
    }
    if (numbers.channels.empty()) return numbers;
    Imf::FrameBuffer places;
    for (FloatChannel& channel : numbers.channels) {
        places.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.values.pixels().data(), window));
    }
    Imf::InputPart in(file, choice.part);
    in.setFrameBuffer(places);
    in.readPixels(window.min.y, window.max.y);
    return numbers;
}

}  // namespace

ExrNumbers read_exr_numbers(const std::filesystem::path& path) {
    const int exr_threads = use_exr_threads(0);
    check_exr_header(path);
    try {
        constexpr bool kReconstructChunkTable = false;
        Imf::MultiPartInputFile file(path.c_str(), exr_threads, kReconstructChunkTable);
        return read_checked(file);
    } catch (const std::exception& error) {
        throw IoError(path, exr_reason(error, path));
    }
}

}  // namespace emulsion
