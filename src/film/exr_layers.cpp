#include "film/exr_layers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <system_error>

#include <fmt/core.h>

#include "core/parameters.h"

namespace emulsion {

namespace {

constexpr double kMinWavelength_nm = 100.0;
constexpr ParameterRange kWavelengths_nm = {kMinWavelength_nm, 999.999};
constexpr std::size_t kLongestName = 255;  // of the format

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("EXR picture: " + what); }

/// The whole text as a number; false if it is none.
bool read_number(std::string_view text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
}

/// Notes a channel and its size.
class ChannelCheck {
  public:
    explicit ChannelCheck(const Image<XYZ>& xyz) : width_(xyz.width()), height_(xyz.height()) {}

    template <class T>
    void add(const std::string& name, const Image<T>& values) {
        if (name.empty() || name.size() > kLongestName || name.find('\0') != std::string::npos) {
            refuse(fmt::format("a channel's name has {} characters, expected 1 to {}, none of them 0", name.size(),
                               kLongestName));
        }
        if (!names_.insert(name).second) refuse(fmt::format("there are two channels \"{}\", expected one", name));
        if (values.width() != width_ || values.height() != height_) {
            refuse(fmt::format("channel \"{}\" has {}x{} pixels, expected {}x{} as the picture", name, values.width(),
                               values.height(), width_, height_));
        }
    }
    template <class T>
    void add_layer(const std::string& name, const Image<T>& values) {
        constexpr std::array kPicture = {"X", "Y", "Z", "R", "G", "B"};
        if (std::find(kPicture.begin(), kPicture.end(), name) != kPicture.end() || wavelength_of_channel(name)) {
            refuse(fmt::format("a layer's channel is named \"{}\", as one of the picture or its spectrum", name));
        }
        add(name, values);
    }

  private:
    int width_, height_;
    std::set<std::string> names_;
};

}  // namespace

PictureView view_of(const FilmPicture& picture) {
    return {picture.xyz,         picture.floats,   picture.counts,   picture.spectral,
            picture.data_window, picture.width_px, picture.height_px};
}

PictureView view_of(const Image<XYZ>& xyz) {
    return {xyz, {}, {}, {}, {0, 0, xyz.width(), xyz.height()}, xyz.width(), xyz.height()};
}

void validate(const PictureView& picture) {
    const Image<XYZ>& xyz = picture.xyz;
    if (xyz.width() < 1) refuse("0x0 pixels, expected at least one");
    // Half of what coordinates can be in the format; sums of two stay in range.
    constexpr double kFarthest_px = 1 << 29;
    const PixelBounds& window = picture.data_window;
    for (const int corner : {window.x0, window.y0, window.x1, window.y1}) {
        check_range(corner, {-kFarthest_px, kFarthest_px}, "EXR picture: data_window");
    }
    if (window.width() != xyz.width() || window.height() != xyz.height()) {
        refuse(fmt::format("data_window has {}x{} pixels, expected {}x{} as the picture", window.width(),
                           window.height(), xyz.width(), xyz.height()));
    }
    check_range(picture.width_px, {1.0, kFarthest_px}, "EXR picture: width_px");
    check_range(picture.height_px, {1.0, kFarthest_px}, "EXR picture: height_px");

    ChannelCheck channels(xyz);
    for (const FloatChannel& channel : picture.floats) channels.add_layer(channel.name, channel.values);
    for (const CountChannel& channel : picture.counts) channels.add_layer(channel.name, channel.values);
    for (const SpectralChannel& channel : picture.spectral) {
        check_range(channel.centre_nm, kWavelengths_nm, "EXR picture: centre_nm");
        check_range(channel.width_nm, {0.0, kInfinity, RangeEnd::closed, RangeEnd::open}, "EXR picture: width_nm");
        channels.add(spectral_channel_name(channel.centre_nm), channel.values);
    }
}

bool is_always_float(std::string_view channel) {
    const std::string_view layer = channel.substr(0, channel.find('.'));
    return layer == "depth" || layer == "variance";
}

std::string spectral_channel_name(double centre_nm) {
    std::string number = fmt::format("{:.3f}", centre_nm);  // with a point whatever the locale
    std::replace(number.begin(), number.end(), '.', ',');
    return "S0." + number + "nm";
}

std::optional<double> wavelength_of_channel(std::string_view channel) {
    constexpr std::string_view kBefore = "S0.", kAfter = "nm";
    if (channel.size() <= kBefore.size() + kAfter.size() || !channel.starts_with(kBefore) ||
        !channel.ends_with(kAfter)) {
        return std::nullopt;
    }
    std::string number(channel.substr(kBefore.size(), channel.size() - kBefore.size() - kAfter.size()));
    if (number.find_first_not_of("0123456789,eE+-") != std::string::npos) return std::nullopt;
    std::replace(number.begin(), number.end(), ',', '.');
    double wavelength_nm = 0.0;
    if (!read_number(number, wavelength_nm) || !(wavelength_nm > 0.0)) return std::nullopt;
    return wavelength_nm;
}

std::string buckets_text(std::span<const SpectralChannel> spectral) {
    std::vector<std::pair<double, double>> buckets;
    for (const SpectralChannel& channel : spectral) buckets.emplace_back(channel.centre_nm, channel.width_nm);
    std::sort(buckets.begin(), buckets.end());
    std::string text;
    for (const auto& [centre_nm, width_nm] : buckets) {
        if (!text.empty()) text += ' ';
        text += number_text(centre_nm) + ":" + number_text(width_nm);
    }
    return text;
}

void apply_buckets_text(std::string_view text, std::vector<SpectralChannel>& spectral) {
    std::vector<std::pair<double, double>> buckets;
    while (!text.empty()) {
        const std::string_view bucket = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), bucket.size() + 1));
        const std::size_t colon = bucket.find(':');
        if (colon == std::string_view::npos) return;
        std::pair<double, double> numbers;
        if (!read_number(bucket.substr(0, colon), numbers.first)) return;
        if (!read_number(bucket.substr(colon + 1), numbers.second)) return;
        buckets.push_back(numbers);
    }
    if (buckets.size() != spectral.size()) return;
    constexpr double kRounding_nm = 0.00051;  // of the names, and a little
    for (std::size_t i = 0; i < buckets.size(); ++i) {
        if (!(std::abs(buckets[i].first - spectral[i].centre_nm) < kRounding_nm)) return;
        if (!(buckets[i].second >= 0.0)) return;
    }
    for (std::size_t i = 0; i < buckets.size(); ++i) {
        spectral[i].centre_nm = buckets[i].first;
        spectral[i].width_nm = buckets[i].second;
    }
}

}  // namespace emulsion
