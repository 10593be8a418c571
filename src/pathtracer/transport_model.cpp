#include "pathtracer/transport_model.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/name_key.h"
#include "core/named_value.h"
#include "spectrum/rgb_space.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {

namespace {

constexpr std::string_view kStrategyKind = "wavelength strategy";

constexpr Matrix3 kSharpFromXyz = {{{
    {1.2694, -0.0988, -0.1706},
    {-0.8364, 1.8006, 0.0357},
    {0.0297, -0.0315, 1.0018},
}}};

bool is_sharp(std::string_view space) { return name_key(space) == name_key(kSharpChannels); }

/// The text up to the first colon, and what is behind it; nothing if there is none.
std::pair<std::string_view, std::optional<std::string_view>> split(std::string_view text) noexcept {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return {text, std::nullopt};
    return {text.substr(0, colon), text.substr(colon + 1)};
}

[[noreturn]] void refuse(std::string_view text, std::string_view expected) {
    throw std::invalid_argument(fmt::format("transport model: found \"{}\", expected {}", text, expected));
}

/// What `model:` and the like lack.
void require_some(const std::optional<std::string_view>& part, std::string_view text, std::string_view expected) {
    if (part && part->empty()) refuse(text, expected);
}

/// As to_text() has it.
std::string channel_space_name(std::string_view name) {
    if (is_sharp(name)) return std::string(kSharpChannels);
    try {
        return rgb_space(name).name;
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("{} or {}", error.what(), kSharpChannels));
    }
}

int parsed_int(std::string_view text, std::string_view what) {
    int value = 0;
    parse_number(text, what, value);
    return value;
}

SpectralModel parse_spectral(std::string_view text, const std::optional<std::string_view>& rest) {
    constexpr std::string_view kExpected = "spectral:N[:STRATEGY]";
    SpectralModel model;
    require_some(rest, text, kExpected);
    if (!rest) return model;
    const auto [count, strategy] = split(*rest);
    if (count.empty()) refuse(text, kExpected);
    require_some(strategy, text, kExpected);
    model.wavelengths = parsed_int(count, "transport model spectral: wavelengths");
    if (strategy) model.strategy = parse_named<WavelengthStrategy>(*strategy, kStrategyKind);
    return model;
}

RgbModel parse_rgb(std::string_view text, const std::optional<std::string_view>& rest) {
    require_some(rest, text, "rgb[:SPACE]");
    return rest ? RgbModel{channel_space_name(*rest)} : RgbModel{};
}

BasisModel parse_basis(std::string_view text, const std::optional<std::string_view>& rest) {
    require_some(rest, text, "basis:K");
    return rest ? BasisModel{parsed_int(*rest, "transport model basis: functions")} : BasisModel{};
}

void check(const SpectralModel& model) {
    if (std::find(kWavelengthCounts.begin(), kWavelengthCounts.end(), model.wavelengths) == kWavelengthCounts.end()) {
        throw std::invalid_argument(fmt::format("transport model spectral: wavelengths {}: must be one of {}",
                                                model.wavelengths, fmt::join(kWavelengthCounts, ", ")));
    }
    validate_named(model.strategy, kStrategyKind);
}
void check(const RgbModel& model) { static_cast<void>(channel_space_from_xyz(model.space)); }
void check(const PrefilteredRgbModel& /*model*/) {}
void check(const BasisModel& model) {
    if (model.functions >= kFewestBasisFunctions && model.functions <= kMostBasisFunctions) return;
    throw std::invalid_argument(fmt::format("transport model basis: functions {}: must be in [{}, {}]", model.functions,
                                            kFewestBasisFunctions, kMostBasisFunctions));
}

/// With its parameters only where they are not the defaults.
std::string strategy_text(const WavelengthStrategy& strategy) {
    return std::visit(
        [](const auto& s) {
            const bool plain = s == std::decay_t<decltype(s)>{};
            return plain ? std::string(s.kName) : to_text(WavelengthStrategy{s});
        },
        strategy);
}

std::string text_of(const SpectralModel& model) {
    std::string count = fmt::format("{}:{}", SpectralModel::kName, model.wavelengths);
    if (std::holds_alternative<HeroVisible>(model.strategy)) return count;
    return fmt::format("{}:{}", count, strategy_text(model.strategy));
}
std::string text_of(const RgbModel& model) { return fmt::format("{}:{}", RgbModel::kName, model.space); }
std::string text_of(const PrefilteredRgbModel& /*model*/) { return std::string(PrefilteredRgbModel::kName); }
std::string text_of(const BasisModel& model) { return fmt::format("{}:{}", BasisModel::kName, model.functions); }

}  // namespace

std::string to_text(const TransportModel& model) {
    return std::visit([](const auto& m) { return text_of(m); }, model);
}

TransportModel parse_transport_model(std::string_view text, std::string_view others) {
    const auto [name, rest] = split(text);
    const std::string key = name_key(name);
    TransportModel model;
    if (key == SpectralModel::kName) {
        model = parse_spectral(text, rest);
    } else if (key == RgbModel::kName) {
        model = parse_rgb(text, rest);
    } else if (key == PrefilteredRgbModel::kName) {
        if (rest) refuse(text, "\"rgb-prefiltered\" alone");
        model = PrefilteredRgbModel{};
    } else if (key == BasisModel::kName) {
        model = parse_basis(text, rest);
    } else {
        const std::string forms = "spectral:N[:STRATEGY], rgb[:SPACE], rgb-prefiltered";
        refuse(text, others.empty() ? forms + " or basis:K" : fmt::format("{}, basis:K or {}", forms, others));
    }
    validate(model);
    return model;
}

void validate(const TransportModel& model) {
    std::visit([](const auto& m) { check(m); }, model);
}

std::vector<TransportModelDescription> describe_transport_models() {
    std::vector<std::string_view> strategies;
    for_each_alternative<WavelengthStrategy>([&](auto strategy) { strategies.push_back(decltype(strategy)::kName); });
    return {
        {"rgb[:SPACE]", "three channels of a linear RGB space (`emulsion color list spaces`, or sharp) [space: sRGB]"},
        {"rgb-prefiltered", "three sharp channels, surfaces as they look in the scene's light"},
        {"basis:K", fmt::format("K functions fitted to the scene's spectra, {} to {} [K: {}]", kFewestBasisFunctions,
                                kMostBasisFunctions, BasisModel{}.functions)},
        {"spectral:N[:STRATEGY]", fmt::format("N wavelengths to a path, one of {} [N: {}], drawn by {} [strategy: {}]",
                                              fmt::join(kWavelengthCounts, ", "), SpectralModel{}.wavelengths,
                                              fmt::join(strategies, ", "), strategies.front())}};
}

Matrix3 channel_space_from_xyz(std::string_view name) {
    return is_sharp(name) ? kSharpFromXyz : rgb_from_xyz(rgb_space(channel_space_name(name)));
}

}  // namespace emulsion
