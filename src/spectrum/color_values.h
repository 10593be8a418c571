#pragma once
// What the colour systems (spectrum/color_system.h) have in common: the numbers of a colour, and the description of the
// components that they stand for.

#include <array>
#include <string_view>

namespace emulsion {

class ColorContext;

/// The components of a colour in some system, in the order of its kComponents; unused ones are 0.
struct ColorValues {
    std::array<double, 4> value{};
    int count = 3;  ///< 3 or 4
    bool operator==(const ColorValues&) const = default;
};

/// One component of a colour system. No component is held to its range: colours outside a display's gamut leave it.
struct ColorComponent {
    std::string_view name;     ///< as the field writes it: "L*", "Cb"
    double min = 0.0;          ///< least value over the gamut of sRGB, with its white and transfer function
    double max = 0.0;          ///< greatest value there; both rounded outwards to four digits
    std::string_view unit;     ///< empty if it has none
    std::string_view meaning;  ///< a few words, no full stop
    bool operator==(const ColorComponent&) const = default;
};

}  // namespace emulsion
