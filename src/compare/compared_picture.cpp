#include "compare/compared_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "spectrum/observer.h"

namespace emulsion {

namespace {

/// The layer of that name; nullptr if there is none.
template <class Channel>
const Channel* find_layer(const std::vector<Channel>& layers, std::string_view name) {
    const auto found = std::ranges::find(layers, name, &Channel::name);
    return found == layers.end() ? nullptr : &*found;
}

/// "observer=NAME" among the film's options; the default if there is none.
std::string observer_of(const FilmMetadata& metadata, const std::string& other) {
    constexpr std::string_view kKey = " observer=";
    const std::string options = " " + metadata.film;
    const std::size_t key = options.find(kKey);
    if (key == std::string::npos) return other;
    const std::size_t begin = key + kKey.size();
    return options.substr(begin, options.find(' ', begin) - begin);
}

void take_noise(const FilmImage& image, ComparedPicture& picture) {
    constexpr std::array<std::pair<const char*, float XYZ::*>, 3> kLayers = {
        {{"standard-error.X", &XYZ::x}, {"standard-error.Y", &XYZ::y}, {"standard-error.Z", &XYZ::z}}};
    int found = 0;
    for (const auto& [name, component] : kLayers) found += find_layer(image.floats, name) != nullptr ? 1 : 0;
    if (find_layer(image.floats, "standard-error.Y") == nullptr) return;
    picture.noise = found == 3 ? KnownNoise::xyz : KnownNoise::luminance;
    picture.standard_error = Image<XYZ>(image.xyz.width(), image.xyz.height());
    const auto unit = static_cast<float>(image.white_luminance_cdm2);
    for (const auto& [name, component] : kLayers) {
        if (picture.noise == KnownNoise::luminance && component != &XYZ::y) continue;
        const auto& values = find_layer(image.floats, name)->values;
        for (std::size_t i = 0; i < values.pixels().size(); ++i) {
            picture.standard_error.pixels()[i].*component = unit * values.pixels()[i];
        }
    }
    const CountChannel* samples = find_layer(image.counts, "samples");
    if (samples == nullptr) return;
    constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t i = 0; i < samples->values.pixels().size(); ++i) {
        if (samples->values.pixels()[i] < 2) picture.standard_error.pixels()[i] = {kUnknown, kUnknown, kUnknown};
    }
}

template <class T>
Image<T> part_of(const Image<T>& image, int x0, int y0, int width, int height) {
    Image<T> part(width, height, UnsetPixels{});
    for (int y = 0; y < height; ++y) {
        std::ranges::copy(image.row(y0 + y).subspan(static_cast<std::size_t>(x0), static_cast<std::size_t>(width)),
                          part.row(y).begin());
    }
    return part;
}

}  // namespace

ComparedPicture compared_picture(FilmImage image) {
    ComparedPicture picture{
        .xyz = {}, .window = image.data_window, .width_px = image.width_px, .height_px = image.height_px};
    take_noise(image, picture);
    picture.observer = observer_of(image.metadata, picture.observer);
    const std::string& sampling = image.metadata.sampling;
    if (!sampling.empty() && !sampling.starts_with("independent")) picture.estimate = NoiseEstimate::upper_bound;
    if (!image.metadata.renderer_version.empty()) picture.seeds = {image.metadata.seed};
    picture.xyz = std::move(image.xyz);
    picture.notes = std::move(image.notes);
    return picture;
}

ComparedPicture mean_of(const ComparedPicture& first, const ComparedPicture& second) {
    if (first.window != second.window || first.width_px != second.width_px || first.height_px != second.height_px) {
        throw std::invalid_argument("one picture has the pixels " + to_string(first.window) + ", the other " +
                                    to_string(second.window) + " of their frames: expected the same of the same frame");
    }
    if (observer(first.observer).name != observer(second.observer).name) {
        throw std::invalid_argument("one picture is of the observer " + first.observer + ", the other of " +
                                    second.observer + ": expected the same");
    }
    if (const auto seed = common_seed(first, second)) {
        throw std::invalid_argument("both pictures have seed " + std::to_string(*seed) +
                                    ": expected independent noise, of another seed each");
    }
    ComparedPicture mean = first;
    mean.noise = KnownNoise::xyz;
    mean.estimate = NoiseEstimate::unbiased;
    mean.standard_error = Image<XYZ>(mean.xyz.width(), mean.xyz.height());
    mean.seeds.insert(mean.seeds.end(), second.seeds.begin(), second.seeds.end());
    mean.notes.insert(mean.notes.end(), second.notes.begin(), second.notes.end());
    for (const auto component : {&XYZ::x, &XYZ::y, &XYZ::z}) {
        for (std::size_t i = 0; i < mean.xyz.pixels().size(); ++i) {
            const double one = first.xyz.pixels()[i].*component, other = second.xyz.pixels()[i].*component;
            mean.xyz.pixels()[i].*component = static_cast<float>(0.5 * (one + other));
            mean.standard_error.pixels()[i].*component = static_cast<float>(0.5 * std::abs(one - other));
        }
    }
    return mean;
}

std::optional<std::uint64_t> common_seed(const ComparedPicture& a, const ComparedPicture& b) {
    const auto found = std::ranges::find_first_of(a.seeds, b.seeds);
    return found == a.seeds.end() ? std::nullopt : std::optional(*found);
}

PixelBounds common_window(const ComparedPicture& a, const ComparedPicture& b) {
    const auto size = [](const ComparedPicture& picture) {
        return std::to_string(picture.width_px) + "x" + std::to_string(picture.height_px);
    };
    if (a.width_px != b.width_px || a.height_px != b.height_px) {
        throw std::invalid_argument("A is of a frame of " + size(a) + " pixels, B of one of " + size(b) +
                                    ": expected the same");
    }
    const PixelBounds common{std::max(a.window.x0, b.window.x0), std::max(a.window.y0, b.window.y0),
                             std::min(a.window.x1, b.window.x1), std::min(a.window.y1, b.window.y1)};
    if (common.width() >= 1 && common.height() >= 1) return common;
    throw std::invalid_argument("A has the pixels " + to_string(a.window) + " of its frame, B " + to_string(b.window) +
                                ": expected some that both have");
}

ComparedPicture cropped(const ComparedPicture& picture, const PixelBounds& window) {
    const auto part = [&]<class T>(const Image<T>& image) {
        return part_of(image, window.x0 - picture.window.x0, window.y0 - picture.window.y0, window.width(),
                       window.height());
    };
    ComparedPicture inside{.xyz = part(picture.xyz),
                           .window = window,
                           .width_px = picture.width_px,
                           .height_px = picture.height_px,
                           .noise = picture.noise,
                           .estimate = picture.estimate};
    if (picture.noise != KnownNoise::none) inside.standard_error = part(picture.standard_error);
    inside.observer = picture.observer;
    inside.seeds = picture.seeds;
    inside.notes = picture.notes;
    return inside;
}

}  // namespace emulsion
