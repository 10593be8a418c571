#include "spectrum/color_system.h"

#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <fmt/core.h>

#include "core/visit.h"

namespace emulsion {

namespace {

template <class T, class... Ts>
concept AnyOf = (std::same_as<T, Ts> || ...);

template <class T>
concept DefinedForD65 = AnyOf<T, OklabSystem, OklchSystem, IptSystem, IctcpSystem>;

template <class T>
concept MadeOfRgb = YcbcrSystem<T> || AnyOf<T, LinearRgbSystem, OpponentSystem, EncodedRgbSystem, HsvSystem, HslSystem,
                                            CmySystem, CmykSystem, YuvSystem, YiqSystem>;

template <class System>
XYZd white_of(const System& /*system*/, const ColorContext& context) noexcept {
    return context.white();
}
template <DefinedForD65 System>
XYZd white_of(const System& /*system*/, const ColorContext& /*context*/) noexcept {
    return xyz_of(Chromaticity{0.3127, 0.329});
}
template <MadeOfRgb System>
XYZd white_of(const System& /*system*/, const ColorContext& context) noexcept {
    return xyz_of(context.rgb().white);  // which throws nothing: the context has its matrix
}
XYZd white_of(const NormalisedRgbSystem& /*system*/, const ColorContext& /*context*/) noexcept {
    return {1.0, 1.0, 1.0};
}

}  // namespace

XYZd white_of(const ColorSystem& system, const ColorContext& context) noexcept {
    return visit_noexcept([&](const auto& chosen) noexcept { return white_of(chosen, context); }, system);
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
