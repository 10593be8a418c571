// `emulsion color spectrum`: what a spectrum looks like, in numbers.

#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/color_arguments.h"
#include "cli/color_tasks.h"
#include "cli/json_text.h"
#include "cli/messages.h"
#include "cli/number_rows.h"
#include "core/error.h"
#include "spectrum/catalogue.h"
#include "spectrum/cielab.h"
#include "spectrum/cieluv.h"
#include "spectrum/color_rendering.h"
#include "spectrum/color_temperature.h"
#include "spectrum/colorimetry.h"
#include "spectrum/dominant_wavelength.h"

namespace emulsion::cli {

namespace {

struct Options {
    std::string spectrum;
    std::optional<std::string> illuminant, white;
    std::string observer = "cie_1931_2deg";
    bool json = false;
};

/// The spectrum to be described, and how it is to be taken.
struct Subject {
    std::string name;
    Spectrum spectrum;
    std::optional<std::string> illuminant;  ///< set for a reflectance, unset for a light
};

struct Description {
    XYZd xyz;  ///< relative under the illuminant, or of a light: Y in cd/m^2
    Chromaticity chromaticity, white;
    Uv1976 uv;
    std::optional<Lab> lab;  ///< of a light: scaled to the white's Y, if its own is > 0
    std::optional<Luv> luv;
    std::optional<DominantWavelength> dominant;             ///< where Y > 0
    std::optional<CorrelatedColorTemperature> temperature;  ///< within kLargestDuv of the blackbodies
    std::optional<double> color_rendering;                  ///< Ra of a light that has a temperature
};

PiecewiseLinearSpectrum read_spectrum_file(const std::filesystem::path& path, const Observer& by) {
    constexpr std::array<std::string_view, 2> kColumns = {"wavelength (nm)", "value"};
    const NumberRows rows = read_number_rows(path, kColumns);
    PiecewiseLinearSpectrum spectrum;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double lambda_nm = rows.row(i)[0];
        if (!spectrum.lambda_nm.empty() && !(lambda_nm > spectrum.lambda_nm.back())) {
            throw IoError(path, fmt::format("row {}: found wavelength {}, expected more than the {} before it", i + 1,
                                            lambda_nm, spectrum.lambda_nm.back()));
        }
        spectrum.lambda_nm.push_back(lambda_nm);
        spectrum.value.push_back(rows.row(i)[1]);
    }
    if (rows.size() < 2) {
        throw IoError(path, fmt::format("has {} row{}, expected two or more with wavelength (nm) and value in each",
                                        rows.size(), rows.size() == 1 ? "" : "s"));
    }
    const double first_nm = spectrum.lambda_nm.front(), last_nm = spectrum.lambda_nm.back();
    if (last_nm <= by.first_nm || first_nm >= by.last_nm()) {
        throw IoError(path, fmt::format("has wavelengths from {} to {}, expected nanometres, some of them in {}-{}",
                                        first_nm, last_nm, by.first_nm, by.last_nm()));
    }
    return spectrum;
}

Subject find_subject(const Options& options) {
    if (const NamedSpectrumInfo* entry = find_in_catalogue(options.spectrum)) {
        const bool is_reflectance = entry->group == "reflectance";
        if (!is_reflectance && entry->group != "illuminant" && entry->group != "emission") {
            throw std::invalid_argument(
                fmt::format("{} is a spectrum of the group \"{}\", expected a reflectance or a "
                            "light (emulsion color list reflectance)",
                            entry->name, entry->group));
        }
        if (!is_reflectance && options.illuminant) {
            throw std::invalid_argument(
                fmt::format("{} is a light, expected a reflectance with --illuminant", entry->name));
        }
        const std::optional<std::string> illuminant = options.illuminant.value_or("D65");
        return {entry->name, spectrum_of(*entry), is_reflectance ? illuminant : std::nullopt};
    }
    if (options.spectrum != "-" && !std::filesystem::exists(options.spectrum)) {
        try {
            static_cast<void>(catalogue_spectrum(options.spectrum));
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(
                fmt::format("{}: {}, and {}", options.spectrum, errno_text(ENOENT), error.what()));
        }
    }
    return {options.spectrum, read_spectrum_file(options.spectrum, observer(options.observer)), options.illuminant};
}

std::optional<double> color_rendering_of(const Spectrum& light) {
    try {
        return color_rendering(light).general_index;
    } catch (const std::invalid_argument&) {
        return std::nullopt;  // of a temperature that has no reference
    }
}

Description describe(const Subject& subject, const Options& options) {
    const Observer& by = observer(options.observer);
    Description d;
    d.xyz = subject.illuminant ? xyz_of_reflectance(subject.spectrum, parse_illuminant(*subject.illuminant), by)
                               : xyz_of_radiance(subject.spectrum, by);
    d.white = parse_white(options.white.value_or(subject.illuminant.value_or("D65")), by);
    d.chromaticity = chromaticity_of(d.xyz);
    d.uv = uv_1976_of(d.xyz);
    const bool has_colour = d.xyz.y > 0.0;
    if (subject.illuminant || has_colour) {
        const XYZd white = xyz_of(d.white);
        const XYZd relative = subject.illuminant ? d.xyz : (1.0 / d.xyz.y) * d.xyz;
        d.lab = lab_from_xyz(relative, white);
        d.luv = luv_from_xyz(relative, white);
    }
    if (!has_colour) return d;
    d.dominant = dominant_wavelength(d.chromaticity, d.white, SpectralLocus(by));
    d.temperature = PlanckianLocus(by).nearest(uv_1960_of(d.chromaticity));
    if (d.temperature && std::abs(d.temperature->duv) > kLargestDuv) d.temperature.reset();
    if (!subject.illuminant && d.temperature) d.color_rendering = color_rendering_of(subject.spectrum);
    return d;
}

/// One thing said about the spectrum; no numbers and no words: it has none.
struct Statement {
    std::string_view label, key;  ///< in text, in JSON
    std::string words;
    std::vector<double> numbers;
};

std::vector<Statement> statements(const Subject& subject, const Options& options, const Description& d) {
    using Numbers = std::vector<double>;
    const auto wavelength = [&](DominantWavelength::Kind kind) {
        return d.dominant && d.dominant->kind == kind ? Numbers{d.dominant->lambda_nm} : Numbers{};
    };
    const bool is_light = !subject.illuminant;
    std::vector<Statement> all = {
        {"spectrum", "spectrum", subject.name, {}},
        {"taken as", "kind", is_light ? "light, W m^-2 sr^-1 nm^-1" : "reflectance", {}},
        {"illuminant", "illuminant", subject.illuminant.value_or(""), {}},
        {"observer", "observer", options.observer, {}},
        {"white x y", "white_xy", "", {d.white.x, d.white.y}},
        {is_light ? "X Y Z (Y in cd/m^2)" : "X Y Z", "XYZ", "", {d.xyz.x, d.xyz.y, d.xyz.z}},
        {is_light ? "x y Y (Y in cd/m^2)" : "x y Y", "xyY", "", {d.chromaticity.x, d.chromaticity.y, d.xyz.y}},
        {"u' v'", "uv_1976", "", {d.uv.u, d.uv.v}},
        {is_light ? "L* a* b* (at Y = 1)" : "L* a* b*", "Lab", "",
         d.lab ? Numbers{d.lab->l, d.lab->a, d.lab->b} : Numbers{}},
        {is_light ? "L* u* v* (at Y = 1)" : "L* u* v*", "Luv", "",
         d.luv ? Numbers{d.luv->l, d.luv->u, d.luv->v} : Numbers{}},
        {"dominant wavelength, nm", "dominant_wavelength_nm", "", wavelength(DominantWavelength::Kind::dominant)},
        {"complementary, nm", "complementary_wavelength_nm", "", wavelength(DominantWavelength::Kind::complementary)},
        {"excitation purity", "excitation_purity", "", d.dominant ? Numbers{d.dominant->excitation_purity} : Numbers{}},
        {"colour temperature, K", "cct_K", "", d.temperature ? Numbers{d.temperature->temperature_K} : Numbers{}},
        {"Duv", "duv", "", d.temperature ? Numbers{d.temperature->duv} : Numbers{}},
        {"luminance, cd/m^2", "luminance_cdm2", "", is_light ? Numbers{d.xyz.y} : Numbers{}},
        {"colour rendering Ra", "Ra", "", d.color_rendering ? Numbers{*d.color_rendering} : Numbers{}},
    };
    return all;
}

void print_text(const std::vector<Statement>& statements) {
    for (const Statement& statement : statements) {
        std::string value = statement.words;
        for (const double number : statement.numbers) {
            if (!value.empty()) value += ' ';
            value += std::isfinite(number) ? fmt::format("{:.17g}", number) : "none";
        }
        print_output(fmt::format("{:<25}{}\n", statement.label, value.empty() ? "none" : value));
    }
}

std::string json_value(const Statement& statement) {
    if (!statement.words.empty()) return json_text(statement.words);
    if (statement.numbers.empty()) return "null";
    if (statement.numbers.size() == 1) return json_number(statement.numbers.front());
    std::string text;
    for (const double value : statement.numbers) text += (text.empty() ? "[" : ", ") + json_number(value);
    return text + "]";
}

void print_json(const std::vector<Statement>& statements) {
    std::string separator = "{\n";
    for (const Statement& statement : statements) {
        print_output(fmt::format("{}  \"{}\": {}", separator, statement.key, json_value(statement)));
        separator = ",\n";
    }
    print_output("\n}\n");
}

/// Adds a flag whose text `parse` keeps; the std::invalid_argument that it throws becomes bad usage.
template <class Parse>
void add_checked_name(CLI::App& command, const std::string& flag, const std::string& help, const std::string& shape,
                      const Parse& parse) {
    command
        .add_option_function<std::string>(
            flag, [flag, parse](const std::string& text) { parse_for(flag, [&] { parse(text); }); }, help)
        ->option_text(shape);
}

}  // namespace

ColorTask add_color_spectrum(CLI::App& color) {
    CLI::App& command = *color.add_subcommand("spectrum", "What a spectrum looks like: XYZ, CIELAB, wavelength, ...");
    const auto options = std::make_shared<Options>();
    command
        .add_option("SPECTRUM", options->spectrum,
                    "A name (emulsion color list), or a file with wavelength (nm) and value in each row: a reflectance "
                    "if there is an --illuminant, else a light")
        ->required()
        ->option_text(" ");
    add_checked_name(command, "--illuminant", "Light that a reflectance is seen under [default: D65]", "NAME",
                     [options](const std::string& text) {
                         static_cast<void>(parse_illuminant(text));
                         options->illuminant = text;
                     });
    add_checked_name(command, "--observer", "Standard observer [default: " + options->observer + "]", "NAME",
                     [options](const std::string& text) {
                         static_cast<void>(observer(text));
                         options->observer = text;
                     });
    add_checked_name(command, "--white", "White of CIELAB, CIELUV and purity [default: the illuminant; of a light D65]",
                     "NAME|x,y", [options](const std::string& text) {
                         static_cast<void>(parse_white(text));
                         options->white = text;
                     });
    command.add_flag("--json", options->json, "As one JSON object [default: text]");
    command.footer(
        "Between the rows of a file are straight lines, outside them 0. A light is taken as W m^-2 sr^-1 nm^-1, also "
        "where its table is relative, like those of the CIE's illuminants: then its luminance means nothing.");
    return {&command, [options] {
                const Subject subject = find_subject(*options);
                const Description description = describe(subject, *options);
                const std::vector<Statement> all = statements(subject, *options, description);
                options->json ? print_json(all) : print_text(all);
            }};
}

}  // namespace emulsion::cli
