#include "cli/render_values.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>

#include <CLI/CLI.hpp>

#include "cli/number_list.h"
#include "cli/option_checks.h"

namespace emulsion::cli {

namespace {

/// \throws CLI::ValidationError unless the text is so many numbers.
template <class Number, std::size_t N>
std::array<Number, N> numbers_of(const std::string& text, char separator, const char* option, const char* expected) {
    const auto numbers = cli::numbers_of<Number>(text, separator);
    if (!numbers || numbers->size() != N) throw CLI::ValidationError(option, found_expected(text, expected));
    std::array<Number, N> all{};
    std::copy(numbers->begin(), numbers->end(), all.begin());
    return all;
}

}  // namespace

std::pair<int, int> parse_resolution(const std::string& text) {
    const auto [width, height] = numbers_of<int, 2>(text, 'x', "--resolution", "WIDTHxHEIGHT in pixels");
    check_option("--resolution", FilmOptions{.width_px = width, .height_px = height});
    return {width, height};
}

PixelBounds parse_crop(const std::string& text) {
    constexpr const char* kExpected = "X0,Y0,X1,Y1 in pixels, with 0 <= X0 < X1 and 0 <= Y0 < Y1";
    const auto [x0, y0, x1, y1] = numbers_of<int, 4>(text, ',', "--crop", kExpected);
    if (x0 >= 0 && y0 >= 0 && x0 < x1 && y0 < y1) return {x0, y0, x1, y1};
    throw CLI::ValidationError("--crop", found_expected(text, kExpected));
}

Shard parse_shard(const std::string& text) {
    constexpr const char* kExpected = "I/N, with 1 <= I <= N";
    const auto [number, count] = numbers_of<int, 2>(text, '/', "--shard", kExpected);
    if (number >= 1 && number <= count) return {number, count};
    throw CLI::ValidationError("--shard", found_expected(text, kExpected));
}

SpectralBuckets parse_spectrum(const std::string& text) {
    constexpr const char* kExpected = "N or N:MIN-MAX, a number of buckets and a range in nm";
    SpectralBuckets buckets;
    const std::size_t colon = text.find(':');
    const auto count = number_of<int>(std::string_view(text).substr(0, colon));
    if (!count) throw CLI::ValidationError("--spectrum", found_expected(text, kExpected));
    buckets.count = *count;
    if (colon != std::string::npos) {
        std::tie(buckets.min_nm, buckets.max_nm) =
            std::tuple_cat(numbers_of<double, 2>(text.substr(colon + 1), '-', "--spectrum", kExpected));
    }
    check_option("--spectrum", buckets);
    return buckets;
}

std::vector<AuxLayer> parse_aux(const std::string& text) {
    std::vector<AuxLayer> layers;
    try {
        for (const std::string_view name : split(text, ',')) layers.push_back(known_aux_layer(std::string(name)));
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("--aov", error.what());
    }
    check_option("--aov", FilmOptions{.aux = layers});
    return layers;
}

FilmVariance parse_variance(const std::string& text) {
    if (text == "luminance") return FilmVariance::luminance;
    if (text == "xyz") return FilmVariance::xyz;
    throw CLI::ValidationError("--variance", found_expected(text, "luminance or xyz"));
}

}  // namespace emulsion::cli
