#include "pathtracer/scene_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/units.h"
#include "spectrum/colorimetry.h"
#include "spectrum/named_spectra.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

namespace {

/// What values a spectrum may have.
struct Bounds {
    double max;
    std::string_view expected;
};
constexpr Bounds kReflectanceBounds = {1.0, "reflectances from 0 to 1"};
constexpr Bounds kUnboundedBounds = {HUGE_VAL, "0 or a number above"};

bool within(double value, const Bounds& bounds) noexcept { return value >= 0.0 && value <= bounds.max; }

/// Pairs of wavelength and value. `place_of(i)` is the place of number i.
template <class PlaceOf>
PiecewiseLinearSpectrum spectrum_of_pairs(const std::vector<double>& numbers, const Bounds& bounds, PlaceOf place_of) {
    PiecewiseLinearSpectrum spectrum;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        const double lambda_nm = numbers[i], value = numbers[i + 1];
        const double previous_nm = i == 0 ? 0.0 : numbers[i - 2];
        if (!(lambda_nm > previous_nm)) {
            throw SceneError(place_of(i), fmt::format("the wavelength {} nm", lambda_nm),
                             fmt::format("wavelengths that rise from pair to pair, here one above {} nm", previous_nm));
        }
        if (!within(value, bounds)) {
            throw SceneError(place_of(i + 1), fmt::format("{} at {} nm", value, lambda_nm),
                             std::string(bounds.expected));
        }
        spectrum.lambda_nm.push_back(lambda_nm);
        spectrum.value.push_back(value);
    }
    return spectrum;
}

/// Reads a file of pairs; its errors name places in that file.
PiecewiseLinearSpectrum read_spectrum_file(const std::filesystem::path& path, const std::string& content,
                                           const Bounds& bounds) {
    const SourceText source{path, content};
    Lexer lexer(source);
    std::vector<double> numbers;
    std::vector<SourcePlace> places;
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
        numbers.push_back(number_value(token));
        places.push_back(token.place);
    }
    if (numbers.empty() || numbers.size() % 2 != 0) {
        throw SceneError(lexer.peek().place, fmt::format("the end of the file after {} numbers", numbers.size()),
                         "pairs of wavelength and value");
    }
    return spectrum_of_pairs(numbers, bounds, [&](std::size_t i) { return places[i]; });
}

/// \throws SceneError always: the name is neither known nor that of a file.
[[noreturn]] void throw_unknown_spectrum(const SourcePlace& place, const std::string& name) {
    const std::vector<std::string> known = named_spectrum_names();
    const std::vector<std::string_view> names(known.begin(), known.end());
    if (is_known_to_pbrt(name)) {
        throw SceneError(place, "spectrum " + quote(name),
                         fmt::format("a supported one (known to pbrt-v4 and not yet supported here; supported: {})",
                                     fmt::join(names, ", ")));
    }
    throw SceneError(place, "spectrum " + quote(name),
                     "a known one, or a file that can be read" + nearest_hint(name, names));
}

/// A named spectrum, or one from a file.
Spectrum spectrum_of_name(const SceneParameter& parameter, SceneFiles& files, const Bounds& bounds) {
    const std::string& name = parameter.strings.front();
    if (const auto named = named_spectrum(name)) {
        const auto* const table = std::get_if<PiecewiseLinearSpectrum>(&*named);
        const auto outside = [&](double value) { return !within(value, bounds); };
        if (table != nullptr && std::any_of(table->value.begin(), table->value.end(), outside)) {
            throw SceneError(parameter.first_value, "the spectrum " + quote(name), std::string(bounds.expected));
        }
        return *named;
    }
    const std::filesystem::path path = files.path_of(name);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) throw_unknown_spectrum(parameter.first_value, name);
    std::string content;
    try {
        content = files.read(name);
    } catch (const IoError& error) {
        throw SceneError(parameter.first_value, fmt::format("spectrum {} ({})", quote(name), error.reason()),
                         "a known one, or a file that can be read");
    }
    return read_spectrum_file(path, content, bounds);
}

/// The three numbers of an rgb parameter.
RGBd rgb_of(const SceneParameter& parameter, const Bounds& bounds) {
    if (parameter.numbers.size() != 3) {
        throw SceneError(parameter.place, fmt::format("{} values for an rgb colour", parameter.numbers.size()), "3");
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (within(parameter.numbers[i], bounds)) continue;
        throw SceneError(place_of_value(parameter, i), fmt::format("{}", parameter.numbers[i]),
                         std::string(bounds.expected));
    }
    return {parameter.numbers[0], parameter.numbers[1], parameter.numbers[2]};
}

/// Every type but rgb.
Spectrum spectrum_of(const SceneParameter& parameter, SceneFiles& files, const Bounds& bounds) {
    const std::vector<double>& numbers = parameter.numbers;
    if (parameter.type == DeclaredType::blackbody) {
        if (numbers.size() != 1) {
            throw SceneError(parameter.place, fmt::format("{} values for a blackbody", numbers.size()),
                             "1, its temperature");
        }
        if (!(numbers[0] > 0.0)) {
            throw SceneError(parameter.first_value, fmt::format("a temperature of {} K", numbers[0]),
                             "a number above 0");
        }
        return BlackbodySpectrum{numbers[0]};
    }
    if (!parameter.strings.empty()) {
        if (parameter.strings.size() == 1) return spectrum_of_name(parameter, files, bounds);
        throw SceneError(parameter.place, fmt::format("{} names for one spectrum", parameter.strings.size()), "1");
    }
    if (numbers.size() % 2 != 0) {
        throw SceneError(parameter.place, fmt::format("{} numbers for a spectrum", numbers.size()),
                         "pairs of wavelength and value");
    }
    return spectrum_of_pairs(numbers, bounds, [&](std::size_t i) { return place_of_value(parameter, i); });
}

/// What brings a light's spectrum to the photometric value 1, as pbrt-v4 does.
double unit_scale(const Spectrum& spectrum) { return 1.0 / (kLuminousEfficacy * light_normalisation(spectrum)); }

}  // namespace

const RgbUplift& SpectrumReader::uplift(ColorSpace space) {
    constexpr std::array<std::string_view, kColorSpaces> kNames = {"sRGB", "Rec2020", "Display_P3", "ACES2065_1_AP0"};
    const auto index = static_cast<std::size_t>(space);
    auto& uplift = uplifts_.at(index);
    if (!uplift) uplift.emplace(rgb_space(kNames.at(index)));
    return *uplift;
}

Spectrum SpectrumReader::reflectance(const SceneParameter& parameter) {
    if (parameter.type != DeclaredType::rgb) return spectrum_of(parameter, *files_, kReflectanceBounds);
    return uplift(parameter.color_space).reflectance(rgb_of(parameter, kReflectanceBounds));
}

Spectrum SpectrumReader::index_of_refraction(const SceneParameter& parameter) {
    if (parameter.type != DeclaredType::rgb) return spectrum_of(parameter, *files_, kUnboundedBounds);
    return uplift(parameter.color_space).unbounded(rgb_of(parameter, kUnboundedBounds));
}

ScaledSpectrum SpectrumReader::light(const SceneParameter& parameter) {
    const bool is_rgb = parameter.type == DeclaredType::rgb;
    Spectrum spectrum = is_rgb ? uplift(parameter.color_space).light(rgb_of(parameter, kUnboundedBounds))
                               : spectrum_of(parameter, *files_, kUnboundedBounds);
    const double scale = unit_scale(spectrum);
    if (!(scale > 0.0) || !std::isfinite(scale)) {
        throw SceneError(parameter.first_value, "a light spectrum without visible light",
                         "one whose luminance is above 0 and finite");
    }
    return {std::move(spectrum), scale};
}

const ScaledSpectrum& SpectrumReader::default_light(ColorSpace space) {
    auto& light = default_lights_.at(static_cast<std::size_t>(space));
    if (!light) {
        Spectrum spectrum = uplift(space).illuminant();
        const double scale = unit_scale(spectrum);
        light.emplace(ScaledSpectrum{std::move(spectrum), scale});
    }
    return *light;
}

}  // namespace emulsion
