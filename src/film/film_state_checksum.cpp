#include "film/film_state_checksum.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ios>
#include <string_view>
#include <vector>

#include <OpenEXR/ImfStringAttribute.h>

#include "core/content_hash.h"
#include "core/error.h"
#include "film/exr_attributes.h"

namespace emulsion {

namespace {

constexpr const char* kChecksumAttribute = "emulsion.filmStateChecksum";

void note_attribute(const RawAttribute& attribute, FilmStateMark& mark) {
    if (attribute.type != "string") return;
    if (attribute.name == kFilmStateVersionAttribute) mark.version = attribute.value;
    if (attribute.name == kChecksumAttribute && attribute.value.size() == ContentHash::kHexDigits) {
        mark.checksum = attribute.value;
        mark.checksum_position = attribute.value_position;
    }
}

void write_at(const std::filesystem::path& file, std::uint64_t position, const std::string& bytes) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(position));
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) throw IoError(file, "cannot write its checksum");
}

}  // namespace

void add_mark(Imf::Header& header) {
    header.insert(kFilmStateVersionAttribute, Imf::StringAttribute(kFilmStateVersion));
    header.insert(kChecksumAttribute, Imf::StringAttribute(std::string(ContentHash::kHexDigits, '0')));
}

std::optional<FilmStateMark> find_mark(HeaderReader& file) {
    const bool several_parts = read_exr_version(file);
    FilmStateMark mark;
    RawAttribute attribute;
    bool is_there = read_attribute(file, attribute);
    do {
        for (; is_there; is_there = read_attribute(file, attribute)) note_attribute(attribute, mark);
        if (several_parts) is_there = read_attribute(file, attribute);
    } while (is_there);
    if (mark.version.empty() || mark.checksum.empty()) return std::nullopt;
    return mark;
}

std::string checksum_of(HeaderReader& file, const FilmStateMark& mark) {
    std::ifstream& stream = file.stream();
    stream.seekg(0);
    ContentHash hash;
    std::vector<char> piece(std::size_t{1} << 20u);
    std::uint64_t position = 0;
    while (position < file.file_size()) {
        const std::uint64_t size = std::min<std::uint64_t>(piece.size(), file.file_size() - position);
        stream.read(piece.data(), static_cast<std::streamsize>(size));
        if (!stream) file.fail("cannot read");
        const std::uint64_t digits_end = mark.checksum_position + ContentHash::kHexDigits;
        for (std::uint64_t i = std::max(position, mark.checksum_position); i < std::min(position + size, digits_end);
             ++i) {
            piece[static_cast<std::size_t>(i - position)] = '0';
        }
        hash.add(std::string_view(piece.data(), static_cast<std::size_t>(size)));
        position += size;
    }
    stream.seekg(0);
    return hash.hex();
}

void require_whole(HeaderReader& file, const FilmStateMark& mark) {
    if (checksum_of(file, mark) != mark.checksum) {
        file.fail("is a film state that is damaged or cut off: its bytes are not those that were written");
    }
    if (mark.version != kFilmStateVersion) {
        file.fail("is a film state of version " + mark.version + ", expected " + kFilmStateVersion);
    }
}

void seal(const std::filesystem::path& file, const std::filesystem::path& named) {
    try {
        HeaderReader reader(file);
        const auto mark = find_mark(reader);
        if (!mark) reader.fail("cannot write: the header has no room for the checksum");
        write_at(file, mark->checksum_position, checksum_of(reader, *mark));
    } catch (const IoError& error) {
        throw IoError(named, error.reason());
    }
}

}  // namespace emulsion
