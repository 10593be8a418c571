#include "film/exr_header_check.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "film/exr_header_reader.h"

namespace emulsion {

namespace {

struct ChannelFacts {
    std::int64_t bytes = 0, x_sampling = 1, y_sampling = 1;
};

struct HeaderFacts {
    bool has_window = false, has_channels = false;
    std::int64_t width = 0, height = 0;
    std::vector<ChannelFacts> channels;
    int compression = 0;
    std::uint64_t tile_width = 0, tile_height = 0;  // 0: scan lines
    std::int64_t chunk_count = 0;
};

/// What a byte of a file can expand to. Deflate makes at most 1032 bytes of one, PIZ and RLE less, PXR24 4/3 of it; the
/// two of DWA run-length code before they deflate.
double largest_expansion(int compression) {
    constexpr int kNone = 0, kDwaa = 8;
    if (compression == kNone) return 1.0;
    return compression >= kDwaa ? 0x1p17 : 0x1p11;
}

std::vector<ChannelFacts> channels_of(const HeaderReader& file, std::string_view channels) {
    // name, zero, pixel type (0 uint, 1 half, 2 float), 4 bytes of no interest here, x and y sampling; at the end a
    // zero.
    std::vector<ChannelFacts> all;
    std::size_t at = 0;
    while (at < channels.size() && channels[at] != '\0') {
        const std::size_t end_of_name = channels.find('\0', at);
        if (end_of_name == std::string_view::npos || channels.size() - end_of_name < 17) {
            file.fail("is not a valid EXR: its list of channels is cut off");
        }
        all.push_back({word(channels, end_of_name + 1) == 1 ? 2 : 4, signed_word(channels, end_of_name + 9),
                       signed_word(channels, end_of_name + 13)});
        if (all.back().x_sampling < 1 || all.back().y_sampling < 1) {
            file.fail("is not a valid EXR: a channel's sampling is below 1");
        }
        at = end_of_name + 17;
    }
    return all;
}

void note_attribute(const HeaderReader& file, const RawAttribute& attribute, HeaderFacts& facts) {
    const auto& [name, type, value, position] = attribute;
    if (name == "dataWindow" && type == "box2i" && value.size() == 16) {
        facts.width = signed_word(value, 8) - signed_word(value, 0) + 1;
        facts.height = signed_word(value, 12) - signed_word(value, 4) + 1;
        facts.has_window = true;
    } else if (name == "channels" && type == "chlist") {
        facts.channels = channels_of(file, value);
        facts.has_channels = true;
    } else if (name == "compression" && type == "compression" && value.size() == 1) {
        facts.compression = static_cast<unsigned char>(value[0]);
    } else if (name == "tiles" && type == "tiledesc" && value.size() == 9) {
        facts.tile_width = word(value, 0);
        facts.tile_height = word(value, 4);
    } else if (name == "chunkCount" && type == "int" && value.size() == 4) {
        facts.chunk_count = signed_word(value, 0);
    } else if (name == "type" && type == "string" && value.starts_with("deep")) {
        file.fail("is a deep EXR, expected a flat one");
    }
}

std::string size_text(const HeaderFacts& facts) {
    return std::to_string(facts.width) + "x" + std::to_string(facts.height);
}

void check_part(const HeaderReader& file, const HeaderFacts& facts) {
    if (!facts.has_window) file.fail("is not a valid EXR: its header has no dataWindow");
    if (!facts.has_channels) file.fail("is not a valid EXR: its header has no channels");
    // OpenEXR's own limit for coordinates is 2^30.
    constexpr std::int64_t kMost = std::int64_t{1} << 31u;
    if (facts.width < 1 || facts.height < 1 || facts.width > kMost || facts.height > kMost) {
        file.fail("is not a valid EXR: its data window is " + size_text(facts) + " pixels");
    }
    constexpr std::uint64_t kUsualTile = 4096;
    if (facts.tile_width > std::max<std::uint64_t>(kUsualTile, static_cast<std::uint64_t>(facts.width)) ||
        facts.tile_height > std::max<std::uint64_t>(kUsualTile, static_cast<std::uint64_t>(facts.height))) {
        file.fail("is not a valid EXR: its tiles have " + std::to_string(facts.tile_width) + "x" +
                  std::to_string(facts.tile_height) + " pixels, and the picture " + size_text(facts));
    }
}

/// The bytes that a part has in the file at least: its pixels, and 8 for each chunk.
double least_bytes(const HeaderFacts& facts) {
    double pixels = 0.0;
    for (const ChannelFacts& channel : facts.channels) {
        const std::int64_t columns = facts.width / channel.x_sampling, rows = facts.height / channel.y_sampling;
        pixels += static_cast<double>(channel.bytes) * static_cast<double>(columns) * static_cast<double>(rows);
    }
    constexpr std::int64_t kMostRows = 256;  // in a chunk of any compression
    double chunks = static_cast<double>(facts.height) / static_cast<double>(kMostRows);
    if (facts.tile_width > 0 && facts.tile_height > 0) {
        chunks = static_cast<double>(facts.width) / static_cast<double>(facts.tile_width) *
                 static_cast<double>(facts.height) / static_cast<double>(facts.tile_height);
    }
    chunks = std::max(chunks, static_cast<double>(facts.chunk_count));
    return pixels / largest_expansion(facts.compression) + 8.0 * chunks;
}

}  // namespace

void check_exr_header(const std::filesystem::path& path) {
    HeaderReader file(path);
    const bool several_parts = read_exr_version(file);
    double bytes = 0.0;
    RawAttribute attribute;
    bool is_there = read_attribute(file, attribute);
    do {
        HeaderFacts facts;
        for (; is_there; is_there = read_attribute(file, attribute)) note_attribute(file, attribute, facts);
        check_part(file, facts);
        bytes += least_bytes(facts);
        if (bytes > static_cast<double>(file.file_size())) {
            file.fail("is damaged or incomplete: its header promises " + size_text(facts) + " pixels, too many for " +
                      std::to_string(file.file_size()) + " bytes");
        }
        if (several_parts) is_there = read_attribute(file, attribute);
    } while (is_there);
}

}  // namespace emulsion
