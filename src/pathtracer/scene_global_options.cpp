#include "pathtracer/scene_global_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pathtracer/scene_names.h"

namespace emulsion {

namespace {

enum class OptionValue { truth, whole_number, number, string };

struct OptionRow {
    std::string_view name;
    OptionValue value;
    void (*set)(GlobalOptions&, double) = nullptr;  // unset: without effect here
    std::string_view because = {};                  // why
};

constexpr auto kOptions = std::to_array<OptionRow>({
    {"disablepixeljitter", OptionValue::truth, [](GlobalOptions& o, double on) { o.jitter.pixel = on == 0.0; }},
    {"disablewavelengthjitter", OptionValue::truth,
     [](GlobalOptions& o, double on) { o.jitter.wavelength = on == 0.0; }},
    {"seed", OptionValue::whole_number, [](GlobalOptions& o, double seed) { o.seed = static_cast<int>(seed); }},
    {"disabletexturefiltering", OptionValue::truth, nullptr, "textures are not filtered over areas here"},
    {"displacementedgescale", OptionValue::number, nullptr, "nothing is displaced here"},
    {"forcediffuse", OptionValue::truth, nullptr, "materials are taken as they are"},
    {"gpu", OptionValue::truth, nullptr, "rendering is done by the processor"},
    {"msereferenceimage", OptionValue::string, nullptr, "errors are not measured while rendering"},
    {"msereferenceout", OptionValue::string, nullptr, "errors are not measured while rendering"},
    {"pixelstats", OptionValue::truth, nullptr, "it changes no picture"},
    {"quiet", OptionValue::truth, nullptr, "what is shown is up to the program"},
    {"rendercoordsys", OptionValue::string, nullptr, "it changes no picture"},
    {"wavefront", OptionValue::truth, nullptr, "it changes no picture"},
});

/// Small letters, without - and _, as pbrt-v4 compares them.
std::string normalised(std::string_view name) {
    std::string key;
    for (const char c : name) {
        if (c == '-' || c == '_') continue;
        key += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return key;
}

std::string name_of(const Token& token) {
    const std::string text = string_value(token);
    // After the type, if there is one.
    const auto blank = text.find_last_of(" \t");
    return normalised(blank == std::string::npos ? text : text.substr(blank + 1));
}

double value_of(const Token& token, OptionValue kind) {
    switch (kind) {
        case OptionValue::truth:
            if (token.text == "true" || token.text == "false") return token.text == "true" ? 1.0 : 0.0;
            throw SceneError(token.place, describe(token), "true or false");
        case OptionValue::string:
            if (token.kind == TokenKind::string) return 1.0;
            throw SceneError(token.place, describe(token), "a string");
        default:
            break;
    }
    const double number = number_value(token);
    constexpr double kLargest = std::numeric_limits<int>::max(), kSmallest = std::numeric_limits<int>::min();
    const bool is_whole = number == std::trunc(number) && number <= kLargest && number >= kSmallest;
    if (kind == OptionValue::number || is_whole) return number;
    throw SceneError(token.place, describe(token), "a whole number of at most 32 bits");
}

}  // namespace

std::string read_global_option(const Token& name, const Token& value, GlobalOptions& options) {
    const auto& row = supported_row<OptionRow>(name.place, {"option"}, name_of(name), kOptions);
    const double number = value_of(value, row.value);
    if (row.set != nullptr) {
        row.set(options, number);
        return {};
    }
    if (row.value == OptionValue::truth && number == 0.0) return {};  // as it is anyway
    return fmt::format("option {} has no effect: {}", quote(row.name), row.because);
}

}  // namespace emulsion
