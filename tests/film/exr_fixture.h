#pragma once
// A folder of its own for each test of film files, and pictures to write there.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "film/exr_file.h"
#include "support/temporary_folder.h"

namespace emulsion {

namespace fs = std::filesystem;

class ExrFile : public testing::Test {
  protected:
    [[nodiscard]] fs::path file(const std::string& name) const { return folder_.file(name); }
    [[nodiscard]] std::size_t files_in_folder() const { return folder_.names().size(); }

  private:
    TemporaryFolder folder_;
};

/// Values of every size, some negative, with the largest half at hand.
inline Image<XYZ> picture(int width, int height, float scale = 1.0f) {
    Image<XYZ> image(width, height);
    Pcg32 random(7);
    for (XYZ& pixel : image.pixels()) {
        const float size = scale * std::ldexp(1.0f, static_cast<int>(random.next() % 24u) - 12);
        pixel = {size * random.next_float(), size * random.next_float(), size * (random.next_float() - 0.1f)};
    }
    return image;
}

inline FilmMetadata metadata() {
    return {.samples_per_pixel = 64,
            .sample_count = std::uint64_t{1} << 40u,
            .dropped_nan_count = 3,
            .dropped_infinite_count = 5,
            .dropped_negative_luminance_count = 7,
            .faint_count = 11,
            .seed = 0xfedcba9876543210u,
            .renderer_version = "0.1.0 (test)",
            .command_line = "emulsion render \"a b.pbrt\" --spp 64",
            .model = "spectral:4",
            .sampling = "padded-sobol seed=3",
            .pixels = "half: dE00 0.01 mean",
            .filter = "mitchell:radius=2,b=0.3333333,c=0.3333333",
            .film = "sensor=cie-1931",
            .firefly_control = "luminance clamped at 1000 cd/m^2; bias -0.3 %"};
}

/// Every kind of channel and pixel type, not compressed and by the default.
inline const std::vector<ExrOptions> kAllOptions = [] {
    std::vector<ExrOptions> all;
    for (const char* space : {"XYZ", "sRGB"}) {
        for (const PixelType type : {PixelType::float32, PixelType::half}) {
            for (const ExrCompression& compression :
                 {ExrCompression(NoCompression{}), ExrCompression(ZipCompression{})}) {
                all.push_back({.space = space, .pixel_type = type, .compression = compression});
            }
        }
    }
    return all;
}();

inline bool same_bits(const Image<XYZ>& a, const Image<XYZ>& b) {
    return a.width() == b.width() && a.height() == b.height() &&
           std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size_bytes()) == 0;
}

/// A crop with every kind of channel: 13x9 pixels of a frame of 40x30, the last row below it.
inline FilmPicture film_picture() {
    FilmPicture all;
    all.xyz = picture(13, 9);
    all.data_window = {20, 22, 33, 31};
    all.width_px = 40;
    all.height_px = 30;
    Pcg32 random(11);
    const auto values = [&](float scale) {
        Image<float> image(13, 9);
        for (float& value : image.pixels()) value = scale * random.next_float();
        return image;
    };
    for (const char* name : {"albedo.B", "albedo.G", "albedo.R"}) all.floats.push_back({name, values(1.0f)});
    all.floats.push_back({"depth.Z", values(1e6f)});
    all.floats.back().values(0, 0) = std::numeric_limits<float>::infinity();
    all.floats.push_back({"variance.Y", values(1e20f)});
    all.counts.push_back({"samples", Image<std::uint32_t>(13, 9)});
    for (std::uint32_t& count : all.counts.back().values.pixels()) count = random.next();
    all.counts.back().values(3, 3) = 0xffffffffu;
    constexpr double kThird = 1.0 / 3.0;
    all.spectral.push_back({386.0 + 2.0 * kThird, 53.0 + kThird, values(0.1f)});
    all.spectral.push_back({550.938, 10.0, values(0.1f)});
    all.spectral.push_back({828.0, 4.0, values(0.1f)});
    return all;
}

/// A new file each time: some file systems flush one that is overwritten to disk, and these tests write thousands.
inline void write_bytes(const fs::path& path, const std::string& bytes) {
    fs::remove(path);
    write_text(path, bytes);
}

/// IoError of one line that starts with the path.
template <class... Matchers>
auto throws_io_error(const fs::path& path, const Matchers&... matchers) {
    return ThrowsMessage<IoError>(
        testing::AllOf(testing::StartsWith(path.string() + ": "), testing::Not(testing::HasSubstr("\n")), matchers...));
}

}  // namespace emulsion
