#include "film/exr_info.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <optional>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include "core/error.h"
#include "film/exr_attributes.h"
#include "film/exr_channels.h"
#include "film/exr_header_check.h"
#include "film/exr_messages.h"
#include "film/exr_metadata.h"
#include "film/exr_parts.h"
#include "film/exr_read_header.h"

namespace emulsion {

namespace {

std::string type_text(Imf::PixelType type) { return type == Imf::UINT ? "uint" : type == Imf::HALF ? "half" : "float"; }

PixelBounds bounds_of(const Imath::Box2i& box) { return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1}; }

ExrPartInfo part_info(const Imf::Header& header) {
    ExrPartInfo part{.name = header.hasName() ? header.name() : "",
                     .compression = std::string(compression_name(header)),
                     .data_window = bounds_of(header.dataWindow()),
                     .display_window = bounds_of(header.displayWindow()),
                     .channels = {}};
    const Imf::ChannelList& channels = header.channels();
    for (auto it = channels.begin(); it != channels.end(); ++it) {
        part.channels.push_back({it.name(), type_text(it.channel().type)});
    }
    return part;
}

bool has_attribute(const Imf::Header& header, const char* name) {
    return header.findTypedAttribute<Imf::StringAttribute>(name) != nullptr;
}

bool is_film(const Imf::Header& header) {
    bool is_one = false;
    const FilmMetadata fields;
    for_each_metadata_field(fields,
                            [&](const char* name, const auto&) { is_one = is_one || has_attribute(header, name); });
    return is_one;
}

std::string space_text(const std::optional<RgbSpace>& space) {
    if (!space) return kXyzSpaceName;
    const auto is_same = [&](const std::string& name) {
        const auto known = space_as_stored(name);
        return known && known->red == space->red && known->green == space->green && known->blue == space->blue &&
               known->white == space->white;
    };
    const std::vector<std::string> names = exr_space_names();
    const auto found = std::find_if(names.begin(), names.end(), is_same);
    if (found != names.end()) return *found;
    const auto text = [](const Chromaticity& c) { return fmt::format("({:.6g}, {:.6g})", c.x, c.y); };
    return fmt::format("R G B of {}, {}, {}, white {}", text(space->red), text(space->green), text(space->blue),
                       text(space->white));
}

ExrInfo info_of(const Imf::MultiPartInputFile& file) {
    ExrInfo info;
    bool has_sums = false;
    std::optional<ChannelNames> names;
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header& header = file.header(part);
        info.parts.push_back(part_info(header));
        has_sums = has_sums || has_attribute(header, kFilmStateVersionAttribute);
        if (names) continue;
        names = picture_channels(header.channels());
        info.picture_part = names ? static_cast<std::size_t>(part) : 0;
    }
    if (!names) return info;
    const Imf::Header& header = file.header(static_cast<int>(info.picture_part));
    info.kind = has_sums ? ExrKind::film_state : is_film(header) ? ExrKind::film_picture : ExrKind::picture;
    std::vector<std::string> notes;  // read_exr() has them, too
    info.space = space_text(space_of(header, *names, notes));
    info.metadata = read_metadata(header, notes);
    return info;
}

}  // namespace

ExrInfo read_exr_info(const std::filesystem::path& path) {
    check_exr_header(path);
    try {
        const Imf::MultiPartInputFile file(path.c_str());
        return info_of(file);
    } catch (const std::exception& error) {
        throw IoError(path, exr_reason(error, path));
    }
}

}  // namespace emulsion
