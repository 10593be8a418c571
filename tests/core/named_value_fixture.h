#pragma once
// What the tests of named values share: a small variant of them.

#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "core/named_value.h"

namespace emulsion {

struct Plain {
    static constexpr std::string_view kName = "plain";
    static constexpr std::string_view kHelp = "nothing to set";
    bool operator==(const Plain&) const = default;
};

struct Blur {
    static constexpr std::string_view kName = "blur";
    static constexpr std::string_view kHelp = "a picture out of focus";
    float radius_px = 1.5f;
    float strength = std::numeric_limits<float>::infinity();
    int passes = 3;
    bool operator==(const Blur&) const = default;

    static constexpr std::array kParameters = {
        Parameter<Blur>{"radius", &Blur::radius_px, kPositiveFinite, "px", "how far"},
        Parameter<Blur>{"strength", &Blur::strength, kPositive, "", "how much"},
        Parameter<Blur>{"passes", &Blur::passes, {1.0, 16.0}, "", "how often"}};
};

using Effect = std::variant<Plain, Blur>;

/// What parsing a text says when it fails.
inline std::string message_of(std::string_view text) {
    try {
        return "no error: " + to_text(parse_named<Effect>(text, "effect"));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

}  // namespace emulsion
