#include "spectrum/color_system.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <fmt/core.h>

#include "core/visit.h"
#include "spectrum/name_key.h"

namespace emulsion {

ColorSystem parse_color_system(std::string_view text) {
    // Names and parameters alike in small letters, but the numbers keep their points.
    const std::size_t colon = std::min(text.find(':'), text.size());
    std::string spelt = name_key(text.substr(0, colon)) + std::string(text.substr(colon));
    std::transform(spelt.begin(), spelt.end(), spelt.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return parse_named<ColorSystem>(spelt, "colour system");
}

std::span<const ColorComponent> components_of(const ColorSystem& system) noexcept {
    return visit_noexcept(
        []<class T>(const T& /*chosen*/) noexcept { return std::span<const ColorComponent>(T::kComponents); }, system);
}

ColorValues from_xyz(const ColorSystem& system, const XYZd& xyz, const ColorContext& context) noexcept {
    return visit_noexcept([&](const auto& chosen) noexcept { return from_xyz(chosen, xyz, context); }, system);
}

XYZd to_xyz(const ColorSystem& system, const ColorValues& color, const ColorContext& context) {
    const std::size_t expected = components_of(system).size();
    if (color.count < 0 || static_cast<std::size_t>(color.count) != expected) {
        throw std::invalid_argument(
            fmt::format("colour system {}: found {} components, expected {}", to_text(system), color.count, expected));
    }
    return visit_noexcept([&](const auto& chosen) noexcept { return to_xyz(chosen, color, context); }, system);
}

}  // namespace emulsion
