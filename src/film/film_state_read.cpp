#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "core/error.h"
#include "film/exr_attributes.h"
#include "film/exr_header_check.h"
#include "film/exr_header_reader.h"
#include "film/exr_messages.h"
#include "film/exr_metadata.h"
#include "film/exr_threads.h"
#include "film/film_state.h"
#include "film/film_state_checksum.h"
#include "film/film_state_fields.h"
#include "film/film_state_sums.h"

namespace emulsion {

namespace {

constexpr int kPicturePart = 0, kSumsPart = 1;

void require_whole(HeaderReader& file) {
    const std::optional<FilmStateMark> mark = find_mark(file);
    if (!mark) file.fail("is a plain EXR, expected a film state");
    require_whole(file, *mark);
}

FilmStateFields read_fields(const Imf::Header& header) {
    FilmStateFields fields;
    for_each_state_field(fields, [&](const char* name, auto& value) {
        const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
        if (attribute == nullptr) throw std::runtime_error(std::string("its header has no ") + name);
        if (!parse_attribute(attribute->value(), value)) {
            throw std::runtime_error(std::string(name) + " is \"" + attribute->value() + "\", expected a whole number");
        }
    });
    return fields;
}

/// \throws std::runtime_error unless the part has the film's pixels.
void require_window(const Imf::Header& header, const PixelBounds& expected) {
    const Imath::Box2i& window = header.dataWindow();
    const PixelBounds bounds{window.min.x, window.min.y, window.max.x + 1, window.max.y + 1};
    if (bounds == expected) return;
    throw std::runtime_error("its sums are of the pixels " + to_string(bounds) + ", expected " + to_string(expected));
}

/// \throws std::runtime_error unless the part has the channel in the form that we write.
void require_channel(const Imf::Header& header, const std::string& name) {
    const Imf::Channel* channel = header.channels().findChannel(name);
    const bool is_ours = channel && channel->type == Imf::UINT && channel->xSampling == 1 && channel->ySampling == 1;
    if (!is_ours) throw std::runtime_error("its sums have no channel " + name + " of whole numbers");
}

FilmState read_checked(Imf::MultiPartInputFile& file) {
    if (file.parts() != 2 || !file.partComplete(kSumsPart)) throw std::runtime_error("has no complete part of sums");
    const Imf::Header& header = file.header(kSumsPart);
    FilmState state = state_of(read_fields(header));
    std::vector<std::string> notes;
    state.metadata = read_metadata(file.header(kPicturePart), notes);
    if (!notes.empty()) throw std::runtime_error(notes.front());

    const FilmSetup setup(state.options);
    require_window(header, setup.bounds);
    const FilmCounts counts = state.contents.counts;
    state.contents = empty_contents<ExactSums>(setup);
    state.contents.counts = counts;
    Imf::FrameBuffer places;
    const auto width = static_cast<std::size_t>(setup.bounds.width());
    for_each_sum_channel(state.contents, [&](const std::string& name, std::byte* words, std::size_t stride) {
        require_channel(header, name);
        places.insert(name, Imf::Slice::Make(Imf::UINT, words, header.dataWindow(), stride, stride * width));
    });
    Imf::InputPart in(file, kSumsPart);
    in.setFrameBuffer(places);
    in.readPixels(header.dataWindow().min.y, header.dataWindow().max.y);
    return state;
}

}  // namespace

FilmState read_film_state(const std::filesystem::path& path) {
    // One open file throughout: one that is renamed over it meanwhile is another.
    HeaderReader file(path);
    require_whole(file);
    check_exr_header(path);
    try {
        Imf::StdIFStream stream(file.stream(), path.c_str());
        constexpr bool kReconstructChunkTable = false;
        Imf::MultiPartInputFile exr(stream, use_exr_threads(0), kReconstructChunkTable);
        return read_checked(exr);
    } catch (const std::exception& error) {
        throw IoError(path, exr_reason(error, path));
    }
}

bool is_film_state(const std::filesystem::path& path) {
    HeaderReader file(path);
    return find_mark(file).has_value();
}

}  // namespace emulsion
