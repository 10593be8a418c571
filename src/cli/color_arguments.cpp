#include "cli/color_arguments.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/named_option.h"
#include "spectrum/catalogue.h"
#include "spectrum/colorimetry.h"

namespace emulsion::cli {

namespace {

std::optional<RgbSpace> find_rgb_space(std::string_view text) {
    try {
        return rgb_space(text);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

}  // namespace

SpaceArgument parse_space(std::string_view text) {
    if (const std::optional<RgbSpace> rgb = find_rgb_space(text)) return {LinearRgbSystem{}, rgb};
    try {
        return {parse_named<ColorSystem>(text, "colour system"), std::nullopt};
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(
            fmt::format("{}; RGB spaces are names of linear RGB, too (emulsion color list spaces)", error.what()));
    }
}

Spectrum parse_illuminant(std::string_view text) {
    const NamedSpectrumInfo* entry = find_in_catalogue(text);
    Spectrum spectrum = catalogue_spectrum(text);  // which says what is like an unknown name
    if (entry->group != "illuminant" && entry->group != "emission") {
        throw std::invalid_argument(
            fmt::format("{} is a spectrum of the group \"{}\", expected an illuminant (emulsion color list illuminant)",
                        entry->name, entry->group));
    }
    return spectrum;
}

Chromaticity parse_white(std::string_view text, const Observer& observer) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return chromaticity_of(xyz_of_radiance(parse_illuminant(text), observer));
    Chromaticity white;
    parse_number(trimmed(text.substr(0, comma)), "white x", white.x);
    parse_number(trimmed(text.substr(comma + 1)), "white y", white.y);
    const XYZd xyz = xyz_of(white);  // which refuses what has no luminance
    if (xyz.x > 0.0 && xyz.z > 0.0) return white;
    throw std::invalid_argument(fmt::format("white ({}, {}): expected x > 0, y > 0 and x + y < 1", white.x, white.y));
}

ColorContext ContextArguments::context(const SpaceArgument& space, const SpaceArgument& reference) const {
    const RgbSpace& default_space = emulsion::rgb_space(rgb_space);
    const RgbSpace& own = space.rgb ? *space.rgb : default_space;
    const Chromaticity reference_white = reference.rgb ? reference.rgb->white : default_space.white;
    return {own, transfer, xyz_of(white.value_or(reference_white))};
}

void add_context_options(CLI::App& command, ContextArguments& arguments) {
    command
        .add_option_function<std::string>(
            "--rgb-space",
            [&arguments](const std::string& text) {
                parse_for("--rgb-space", [&] { return rgb_space(text); });
                arguments.rgb_space = text;
            },
            "RGB space of rgb, encoded-rgb and the systems made of it [default: " + arguments.rgb_space + "]")
        ->option_text("NAME");
    add_white_option(command, "--white", arguments.white,
                     "White of CIELAB and the like [default: that of the RGB space]");
    add_named_option(command, "--transfer", "transfer", arguments.transfer, "Transfer function of encoded RGB");
}

void add_space_option(CLI::App& command, const std::string& flag, SpaceArgument& space, const std::string& help) {
    command
        .add_option_function<std::string>(
            flag,
            [&space, flag](const std::string& text) { space = parse_for(flag, [&] { return parse_space(text); }); },
            help + " [required]")
        ->required()
        ->option_text("SPACE");
}

CLI::Option* add_white_option(CLI::App& command, const std::string& flag, std::optional<Chromaticity>& white,
                              const std::string& help) {
    return command
        .add_option_function<std::string>(
            flag,
            [&white, flag](const std::string& text) { white = parse_for(flag, [&] { return parse_white(text); }); },
            help)
        ->option_text("NAME|x,y");
}

}  // namespace emulsion::cli
