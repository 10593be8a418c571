#include "spectrum/color_system.h"

#include <cstddef>
#include <stdexcept>
#include <string>

#include <fmt/core.h>

#include "core/visit.h"

namespace emulsion {

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
