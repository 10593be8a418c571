#include "develop/picture_file.h"

#include <array>
#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "display/png_read.h"
#include "film/exr_file.h"
#include "film/pfm_file.h"
#include "film/radiance_file.h"

namespace emulsion {

namespace {

/// The first four bytes; fewer if there are fewer. None of what can't be opened: the reader will say why.
std::string beginning_of(const std::filesystem::path& path) {
    std::string bytes;
    if (!std::filesystem::is_regular_file(path)) return bytes;
    std::array<char, 4> start{};
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), start.size());
    return bytes.assign(start.data(), static_cast<std::size_t>(file.gcount()));
}

std::string printable(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) text += c >= ' ' && c <= '~' ? c : '?';
    return text;
}

FilmImage full_frame(ScenePicture picture) {
    FilmImage image;
    image.width_px = picture.xyz.width();
    image.height_px = picture.xyz.height();
    image.data_window = {0, 0, image.width_px, image.height_px};
    image.xyz = std::move(picture.xyz);
    image.notes = std::move(picture.notes);
    return image;
}

FilmImage read_any(const std::filesystem::path& path, const ExrReadOptions& options) {
    constexpr const char* kExpected = "expected an OpenEXR, Radiance (#?), PFM (PF or Pf) or PNG file";
    std::error_code error;
    const auto type = std::filesystem::status(path, error).type();
    if (type == std::filesystem::file_type::directory) throw IoError(path, std::string("is a folder, ") + kExpected);
    if (std::filesystem::exists(std::filesystem::file_status(type)) && type != std::filesystem::file_type::regular) {
        throw IoError(path, std::string("is not a regular file, ") + kExpected);
    }
    if (std::filesystem::file_size(path, error) == 0) throw IoError(path, std::string("is empty, ") + kExpected);
    const std::string begin = beginning_of(path);
    if (begin.starts_with("#?")) return full_frame(read_radiance(path));
    if (begin.starts_with("PF") || begin.starts_with("Pf")) return full_frame(read_pfm(path));
    if (begin.starts_with("\x89PNG")) {
        PngPicture png = read_png(path);
        png.notes.emplace_back("its white is taken as 1 cd/m^2");
        return full_frame({std::move(png.xyz), std::move(png.notes)});
    }
    const bool is_exr = begin == "\x76\x2f\x31\x01";
    if (!begin.empty() && !is_exr) {
        throw IoError(path, "begins with \"" + printable(begin) + "\": " + kExpected);
    }
    return read_exr(path, options);
}

}  // namespace

ScenePicture read_picture(const std::filesystem::path& path, int threads) {
    FilmImage film = read_any(path, {.layers = ExrLayers::skip, .threads = threads});
    return {std::move(film.xyz), std::move(film.notes)};
}

FilmImage read_picture_and_layers(const std::filesystem::path& path, int threads) {
    return read_any(path, {.layers = ExrLayers::read, .threads = threads});
}

}  // namespace emulsion
