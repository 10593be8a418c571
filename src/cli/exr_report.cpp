#include "cli/exr_report.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/json_text.h"
#include "film/exr_file.h"
#include "film/exr_layers.h"

namespace emulsion::cli {

namespace {

std::string window_json(const PixelBounds& window) {
    return fmt::format("[{}, {}, {}, {}]", window.x0, window.y0, window.x1, window.y1);
}

/// "albedo.R" is R of albedo.
std::pair<std::string, std::string> layer_and_component(const std::string& channel) {
    const std::size_t dot = channel.rfind('.');
    if (dot == std::string::npos) return {channel, ""};
    return {channel.substr(0, dot), channel.substr(dot + 1)};
}

/// "albedo (B G R), samples".
std::string layers_text(const ExrPartInfo& part, const ExrInfo& exr) {
    std::vector<std::pair<std::string, std::string>> layers;
    for (const ExrChannelInfo& channel : part.channels) {
        constexpr std::array<std::string_view, 6> kPicture = {"X", "Y", "Z", "R", "G", "B"};
        const bool is_picture =
            exr.kind != ExrKind::other && std::find(kPicture.begin(), kPicture.end(), channel.name) != kPicture.end();
        if (is_picture || wavelength_of_channel(channel.name)) continue;
        const auto [layer, component] = layer_and_component(channel.name);
        if (layers.empty() || layers.back().first != layer) layers.emplace_back(layer, "");
        std::string& components = layers.back().second;
        if (!component.empty()) components += (components.empty() ? "" : " ") + component;
    }
    std::string text;
    for (const auto& [layer, components] : layers) {
        text += (text.empty() ? "" : ", ") + layer + (components.empty() ? "" : " (" + components + ")");
    }
    return text;
}

std::string spectrum_text(const ExrPartInfo& part) {
    std::vector<double> centres_nm;
    for (const ExrChannelInfo& channel : part.channels) {
        if (const auto centre_nm = wavelength_of_channel(channel.name)) centres_nm.push_back(*centre_nm);
    }
    if (centres_nm.empty()) return "";
    const auto [least, most] = std::minmax_element(centres_nm.begin(), centres_nm.end());
    return fmt::format("{} buckets, centres {:g} to {:g} nm", centres_nm.size(), *least, *most);
}

std::string part_json(const ExrPartInfo& part) {
    std::vector<std::string> channels;
    for (const ExrChannelInfo& channel : part.channels) {
        channels.push_back(json_object({{"name", json_text(channel.name)}, {"type", json_text(channel.type)}}));
    }
    return json_object({{"name", json_text(part.name)},
                        {"compression", json_text(part.compression)},
                        {"data_window", window_json(part.data_window)},
                        {"channels", json_list(channels)}});
}

}  // namespace

void report_size(const ExrInfo& exr, InfoReport& report) {
    const ExrPartInfo& part = exr.parts[exr.picture_part];
    const PixelBounds &data = part.data_window, &frame = part.display_window;
    const std::string size = fmt::format("{}x{} pixels", data.width(), data.height());
    report.line("size",
                data == frame ? size : fmt::format("{}, {} of the frame {}", size, to_string(data), to_string(frame)));
    report.member("width_px", std::to_string(data.width()));
    report.member("height_px", std::to_string(data.height()));
    report.member("data_window", window_json(data));
    report.member("display_window", window_json(frame));
}

void report_channels(const ExrInfo& exr, double white_luminance_cdm2, InfoReport& report) {
    const ExrPartInfo& part = exr.parts[exr.picture_part];
    if (exr.kind != ExrKind::other) {
        const bool is_xyz = exr.space == kXyzSpaceName;
        const auto is_first = [&](const ExrChannelInfo& c) { return c.name == (is_xyz ? "X" : "R"); };
        const auto channel = std::find_if(part.channels.begin(), part.channels.end(), is_first);
        const std::string_view bits = channel->type == "half" ? "16-bit floats" : "32-bit floats";
        report.line("colour",
                    is_xyz ? fmt::format("X Y Z, {}", bits) : fmt::format("R G B, linear {}, {}", exr.space, bits));
        report.line("white luminance", fmt::format("{:g} cd/m^2", white_luminance_cdm2));
        report.member_text("space", exr.space);
        report.member("white_luminance_cdm2", json_number(white_luminance_cdm2));
    }
    report.line(exr.kind == ExrKind::other ? "channels" : "layers", layers_text(part, exr));
    report.line("spectrum", spectrum_text(part));
    report.line("compression", part.compression);
    std::vector<std::string> parts;
    for (const ExrPartInfo& each : exr.parts) {
        parts.push_back(part_json(each));
        if (&each == &part || exr.kind == ExrKind::film_state) continue;
        report.line("other part",
                    fmt::format("{}{}{}x{} pixels, {}", each.name, each.name.empty() ? "" : ": ",
                                each.data_window.width(), each.data_window.height(), layers_text(each, {})));
    }
    report.member("parts", json_list(parts));
}

}  // namespace emulsion::cli
