#include "film/exr_parts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/named_value.h"
#include "film/exr_stream.h"
#include "film/exr_threads.h"

namespace emulsion {

namespace {

/// What OpenEXR has for each alternative of ExrCompression, in its order.
struct CompressionFacts {
    Imf::Compression compression;
    int rows_per_chunk;
};
constexpr std::array<CompressionFacts, std::variant_size_v<ExrCompression>> kCompressions = {{
    {Imf::NO_COMPRESSION, 1},
    {Imf::RLE_COMPRESSION, 1},
    {Imf::ZIPS_COMPRESSION, 1},
    {Imf::ZIP_COMPRESSION, 16},
    {Imf::PIZ_COMPRESSION, 32},
    {Imf::PXR24_COMPRESSION, 16},
    {Imf::B44_COMPRESSION, 32},
    {Imf::B44A_COMPRESSION, 32},
    {Imf::DWAA_COMPRESSION, 32},
    {Imf::DWAB_COMPRESSION, 256},
}};

void write_part(Imf::MultiPartOutputFile& file, int number, const ExrPart& part) {
    Imf::OutputPart out(file, number);
    const int height = part.header.dataWindow().max.y - part.header.dataWindow().min.y + 1;
    for (int first = 0; first < height; first += part.rows_at_once) {
        const int count = std::min(part.rows_at_once, height - first);
        out.setFrameBuffer(part.rows(first, count));
        out.writePixels(count);
    }
}

}  // namespace

void set_compression(Imf::Header& header, const ExrCompression& compression) {
    header.compression() = kCompressions[compression.index()].compression;
    std::visit(
        [&](const auto& chosen) {
            if constexpr (requires { chosen.level; }) header.dwaCompressionLevel() = static_cast<float>(chosen.level);
        },
        compression);
}

std::string_view compression_name(const Imf::Header& header) {
    const std::vector<std::string_view> names = names_of<ExrCompression>();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (kCompressions[i].compression == header.compression()) return names[i];
    }
    return "unknown";
}

int rows_per_chunk(const ExrCompression& compression) noexcept {
    return kCompressions[compression.index()].rows_per_chunk;
}

Imf::Slice exr_slice(Imf::PixelType type, const void* values, std::size_t stride_bytes, const Imf::Header& header,
                     int first, int count) {
    const Imath::Box2i& window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1;
    return Imf::Slice::Make(type, values, Imath::V2i(window.min.x, window.min.y + first), width, count, stride_bytes,
                            stride_bytes * static_cast<std::size_t>(width));
}

void write_exr_parts(const std::filesystem::path& path, std::span<const ExrPart> parts, int threads,
                     const std::function<void(const std::filesystem::path&)>& finish) {
    const int exr_threads = use_exr_threads(threads);
    AtomicFile file(path);
    try {
        std::vector<Imf::Header> headers;
        for (const ExrPart& part : parts) {
            headers.push_back(part.header);
            headers.back().setType(Imf::SCANLINEIMAGE);
        }
        CheckedOStream stream(file.temporary_path(), path);
        {
            constexpr bool kOverrideSharedAttributes = false;
            Imf::MultiPartOutputFile out(stream, headers.data(), static_cast<int>(headers.size()),
                                         kOverrideSharedAttributes, exr_threads);
            for (std::size_t i = 0; i < parts.size(); ++i) write_part(out, static_cast<int>(i), parts[i]);
        }
        stream.finish();
    } catch (const IoError&) {
        throw;
    } catch (const std::exception& error) {
        throw IoError(path, std::string("cannot write: ") + error.what());
    }
    if (finish) finish(file.temporary_path());
    file.commit();
}

}  // namespace emulsion
