#pragma once
// What the tests of dithers share: every dither, the scales they are tried with, pictures.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/named_value.h"
#include "core/random.h"
#include "display/dither.h"

namespace emulsion {

/// Every alternative with each of its choices; parameters that are numbers have their default.
inline std::vector<Dither> every_dither() {
    std::vector<Dither> all;
    for_each_alternative<Dither>([&]<class T>(const T& alternative) {
        std::vector<T> values = {alternative};
        for (const Parameter<T>& parameter : parameters_of<T>()) {
            std::vector<T> more;
            for (const T& value : values) {
                if (parameter.words.empty()) more.push_back(value);
                for (const ParameterWord& choice : parameter.words) {
                    more.push_back(value);
                    read_parameter(choice.word, parameter.name, more.back(), parameter);
                }
            }
            values = std::move(more);
        }
        all.insert(all.end(), values.begin(), values.end());
    });
    return all;
}

/// 1, 2, 4, 8, 10 and 16 bits, and 10 bits of the narrow range.
inline std::array<CodeScale, 7> every_scale() {
    return {code_scale(1, FullRange{}),   code_scale(2, FullRange{}),  code_scale(4, FullRange{}),
            code_scale(8, FullRange{}),   code_scale(10, FullRange{}), code_scale(16, FullRange{}),
            code_scale(10, NarrowRange{})};
}

/// For messages: "bayer:size=8, codes 0 to 255".
inline std::string label(const Dither& dither, const CodeScale& scale) {
    return to_text(dither) + ", codes " + std::to_string(scale.black) + " to " + std::to_string(scale.white);
}

inline Image<float> constant_grey(int width, int height, float value) {
    Image<float> picture(width, height);
    for (float& p : picture.pixels()) p = value;
    return picture;
}

inline Image<RGB> random_picture(int width, int height, unsigned seed) {
    Pcg32 random(seed);
    Image<RGB> picture(width, height);
    for (RGB& p : picture.pixels()) p = {random.next_float(), random.next_float(), random.next_float()};
    return picture;
}

/// Mean of the codes, in encoded values.
inline double mean_of(const Image<std::uint16_t>& codes, const CodeScale& scale) {
    std::int64_t sum = 0;
    for (const int code : codes.pixels()) sum += code - scale.black;
    return static_cast<double>(sum) / (static_cast<double>(scale.steps()) * static_cast<double>(codes.pixels().size()));
}

}  // namespace emulsion
