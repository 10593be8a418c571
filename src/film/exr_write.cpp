#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fcntl.h>
#include <unistd.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/parameters.h"
#include "film/exr_attributes.h"
#include "film/exr_channels.h"
#include "film/exr_file.h"

namespace emulsion {

namespace {

/// A stream for OpenEXR that knows for certain whether every byte was written. OpenEXR's own closes without a look, and
/// its OutputFile writes the table of chunks in a destructor that swallows errors; so the first error is kept here, and
/// finish() throws it.
class CheckedOStream : public Imf::OStream {
  public:
    CheckedOStream(const std::filesystem::path& file, std::filesystem::path named)
        : Imf::OStream(named.c_str()),
          named_(std::move(named)),
          descriptor_(::open(file.c_str(), O_WRONLY | O_CLOEXEC)) {
        if (descriptor_ < 0) fail(errno);
        buffer_.reserve(kBufferBytes);
    }
    ~CheckedOStream() override {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    CheckedOStream(const CheckedOStream&) = delete;
    CheckedOStream& operator=(const CheckedOStream&) = delete;

    void write(const char* bytes, int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (buffer_.size() + size > kBufferBytes) flush();
        if (size >= kBufferBytes) {
            write_all(bytes, size);
        } else {
            buffer_.insert(buffer_.end(), bytes, bytes + size);
        }
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override {
        flush();
        if (::lseek(descriptor_, static_cast<::off_t>(position), SEEK_SET) < 0) fail(errno);
        position_ = position;
    }

    /// To be called when all is written. \throws IoError if anything went wrong, even if nobody listened then.
    void finish() {
        flush();
        if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
    }

  private:
    static constexpr std::size_t kBufferBytes = std::size_t{1} << 18u;

    [[noreturn]] void fail(int error) {
        if (error_ == 0) error_ = error;
        throw IoError(named_, "cannot write: " + errno_text(error_));
    }
    void flush() {
        write_all(buffer_.data(), buffer_.size());
        buffer_.clear();
    }
    void write_all(const char* bytes, std::size_t count) {
        if (error_ != 0) fail(error_);
        while (count > 0) {
            const ::ssize_t written = ::write(descriptor_, bytes, count);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) fail(written < 0 ? errno : ENOSPC);
            bytes += written;
            count -= static_cast<std::size_t>(written);
        }
    }

    std::filesystem::path named_;
    int descriptor_;
    int error_ = 0;
    std::vector<char> buffer_;
    std::uint64_t position_ = 0;
};

std::array<const char*, 3> channel_names(ExrColor color) {
    if (color == ExrColor::xyz) return {"X", "Y", "Z"};
    return {"R", "G", "B"};
}

Imf::Chromaticities chromaticities(ExrColor color) {
    if (color == ExrColor::xyz) return {{1.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, 0.0f}, {1.0f / 3.0f, 1.0f / 3.0f}};
    const RgbSpace space = rec709_as_stored();
    const auto point = [](const Chromaticity& c) {
        return Imath::V2f(static_cast<float>(c.x), static_cast<float>(c.y));
    };
    return {point(space.red), point(space.green), point(space.blue), point(space.white)};
}

float white_luminance_as_stored(const ExrOptions& options) { return static_cast<float>(options.white_luminance_cdm2); }

Imf::Header make_header(const Image<XYZ>& image, const FilmMetadata& metadata, const ExrOptions& options) {
    Imf::Header header(image.width(), image.height());
    header.compression() = options.compression == ExrCompression::none ? Imf::NO_COMPRESSION : Imf::ZIP_COMPRESSION;
    const Imf::PixelType type = options.pixel_type == PixelType::half ? Imf::HALF : Imf::FLOAT;
    for (const char* name : channel_names(options.color)) header.channels().insert(name, Imf::Channel(type));
    Imf::addChromaticities(header, chromaticities(options.color));
    Imf::addWhiteLuminance(header, white_luminance_as_stored(options));
    for_each_metadata_field(metadata, [&](const char* name, const auto& value) {
        header.insert(name, Imf::StringAttribute(attribute_text(value)));
    });
    return header;
}

/// Encodes and writes bands of rows, so that no second picture is held in memory. Value: what a channel is stored as.
template <class Value>
ExrWriteResult write_rows(Imf::OutputFile& file, const Image<XYZ>& image, const ExrOptions& options) {
    constexpr int kBandRows = 64;  // a multiple of every scheme's chunk
    const ChannelEncoder encoder(options);
    const auto width = static_cast<std::size_t>(image.width());
    std::vector<std::array<Value, 3>> band(width * kBandRows);
    ExrWriteResult result;
    for (int first = 0; first < image.height(); first += kBandRows) {
        const int rows = std::min(kBandRows, image.height() - first);
        auto* to = band.data();
        for (int y = first; y < first + rows; ++y) {
            for (const XYZ& xyz : image.row(y)) {
                const ChannelValues channels = encoder.encode(xyz, result);
                *to++ = {Value(channels[0]), Value(channels[1]), Value(channels[2])};
            }
        }
        Imf::FrameBuffer pixels;
        for (std::size_t i = 0; i < 3; ++i) {
            constexpr std::size_t kStride = sizeof(band[0]);
            pixels.insert(channel_names(options.color)[i],
                          Imf::Slice::Make(std::is_same_v<Value, half> ? Imf::HALF : Imf::FLOAT, &band[0][i],
                                           Imath::V2i(0, first), image.width(), rows, kStride, kStride * width));
        }
        file.setFrameBuffer(pixels);
        file.writePixels(rows);
    }
    return result;
}

void check_arguments(const Image<XYZ>& image, const ExrOptions& options) {
    if (image.width() < 1) throw std::invalid_argument("EXR image: 0x0 pixels, expected at least one");
    check_range(options.white_luminance_cdm2, {1e-30, 1e30}, "EXR image: white_luminance_cdm2");
}

}  // namespace

ExrWriteResult write_exr(const std::filesystem::path& path, const Image<XYZ>& xyz, const FilmMetadata& metadata,
                         const ExrOptions& options) {
    check_arguments(xyz, options);
    AtomicFile file(path);
    ExrWriteResult result;
    try {
        CheckedOStream stream(file.temporary_path(), path);
        {
            Imf::OutputFile out(stream, make_header(xyz, metadata, options));
            result = options.pixel_type == PixelType::half ? write_rows<half>(out, xyz, options)
                                                           : write_rows<float>(out, xyz, options);
        }
        stream.finish();
    } catch (const IoError&) {
        throw;
    } catch (const std::exception& error) {
        throw IoError(path, std::string("cannot write: ") + error.what());
    }
    file.commit();
    return result;
}

Image<XYZ> as_stored(const Image<XYZ>& xyz, const ExrOptions& options) {
    check_arguments(xyz, options);
    const ChannelEncoder encoder(options);
    std::optional<RgbSpace> space;
    if (options.color == ExrColor::rec709) space = rec709_as_stored();
    const ChannelDecoder decoder(space, static_cast<double>(white_luminance_as_stored(options)));
    ExrWriteResult ignored;
    Image<XYZ> stored(xyz.width(), xyz.height());
    std::transform(xyz.pixels().begin(), xyz.pixels().end(), stored.pixels().begin(),
                   [&](const XYZ& pixel) { return decoder.decode(encoder.encode(pixel, ignored)); });
    return stored;
}

}  // namespace emulsion
