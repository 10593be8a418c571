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

namespace emulsion {

namespace {

/// What values a spectrum may have.
struct Bounds {
    double min, max;
    std::string_view expected;
};
constexpr Bounds kReflectanceBounds = {0.0, 1.0, "reflectances from 0 to 1"};
constexpr Bounds kUnboundedBounds = {0.0, HUGE_VAL, "0 or a number above"};
constexpr Bounds kAnyNumber = {-HUGE_VAL, HUGE_VAL, "a number"};

bool within(double value, const Bounds& bounds) noexcept { return value >= bounds.min && value <= bounds.max; }

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

/// The lines clamped everywhere, not at their ends alone: those that leave the bounds get a knot where they do.
PiecewiseLinearSpectrum clamped(const PiecewiseLinearSpectrum& table, double min, double max) {
    PiecewiseLinearSpectrum result;
    const auto add = [&](double lambda_nm, double value) {
        if (!result.lambda_nm.empty() && !(lambda_nm > result.lambda_nm.back())) return;
        result.lambda_nm.push_back(lambda_nm);
        result.value.push_back(value);
    };
    for (std::size_t i = 0; i < table.value.size(); ++i) {
        const double lambda_nm = table.lambda_nm[i], value = table.value[i];
        if (i > 0) {
            const double from_nm = table.lambda_nm[i - 1], from = table.value[i - 1];
            // The bounds in the order in which the line meets them.
            for (const double bound : {value > from ? min : max, value > from ? max : min}) {
                if ((from < bound) == (value < bound) || from == bound || value == bound) continue;
                add(from_nm + (bound - from) / (value - from) * (lambda_nm - from_nm), bound);
            }
        }
        add(lambda_nm, std::clamp(value, min, max));
    }
    return result;
}

/// What brings a light's spectrum to the photometric value 1, as pbrt-v4 does.
double unit_scale(const Spectrum& spectrum) { return 1.0 / (kLuminousEfficacy * light_normalisation(spectrum)); }

}  // namespace

Spectrum clamped_reflectance(Spectrum spectrum) {
    auto* const table = std::get_if<PiecewiseLinearSpectrum>(&spectrum);
    if (table == nullptr) return spectrum;
    const auto [least, greatest] = std::ranges::minmax(table->value);
    if (within(least, kReflectanceBounds) && within(greatest, kReflectanceBounds)) return spectrum;
    return clamped(*table, kReflectanceBounds.min, kReflectanceBounds.max);
}

const RgbUplift& SpectrumReader::uplift(ColorSpace space) {
    auto& uplift = uplifts_.at(static_cast<std::size_t>(space));
    if (!uplift) uplift.emplace(rgb_space_of(space));
    return *uplift;
}

Spectrum SpectrumReader::reflectance(const SceneParameter& parameter) {
    if (parameter.type != DeclaredType::rgb) {
        Spectrum spectrum = spectrum_of(parameter, *files_, kAnyNumber);
        auto* const table = std::get_if<PiecewiseLinearSpectrum>(&spectrum);
        if (table == nullptr) return spectrum;
        const auto [least, greatest] = std::ranges::minmax(table->value);
        if (within(least, kReflectanceBounds) && within(greatest, kReflectanceBounds)) return spectrum;
        warnings_->add(parameter.first_value,
                       fmt::format("reflectances from {} to {}, of which what is left below 0 and above 1 is taken for "
                                   "0 and 1",
                                   least, greatest));
        if (least < 0.0) *table = clamped(*table, 0.0, HUGE_VAL);
        return spectrum;
    }
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
