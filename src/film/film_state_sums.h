#pragma once
// The sums of a film as channels of an EXR, straight from and into the memory of its pixels: each sum is a plain two's
// complement integer, its words channels of 32-bit whole numbers with one name and the numbers .0 (the lowest word),
// .1,
// ... behind it. In units of the sums' resolutions (film/exact_sum.h): X, Y, Z of three words, weight of two, samples
// of one; then "sum.00000" and so on of three words and "square.0" of four, in the order of FilmChannels.

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "film/film_contents.h"

namespace emulsion {

static_assert(std::is_standard_layout_v<ExactFilmPixel> && std::is_trivially_copyable_v<ExactFilmPixel>);
static_assert(sizeof(ExactFilmPixel) == 48 && sizeof(ExactSum) == 12 && sizeof(SquareSum) == 16);

/// Calls visit(name, address of the first pixel's word, bytes from a pixel to the next) for every channel. Contents is
/// FilmContents<ExactSums>, const or not, with at least one pixel.
template <class Contents, class Visit>
void for_each_sum_channel(Contents& contents, const Visit& visit) {
    using Byte = std::conditional_t<std::is_const_v<Contents>, const std::byte, std::byte>;
    constexpr std::size_t kWord = sizeof(std::uint32_t);
    const auto visit_words = [&](const std::string& name, Byte* first, std::size_t words, std::size_t stride) {
        for (std::size_t word = 0; word < words; ++word) {
            visit(fmt::format("{}.{}", name, word), first + kWord * word, stride);
        }
    };
    auto* const pixel = reinterpret_cast<Byte*>(contents.pixels.data());
    constexpr std::size_t kPixel = sizeof(ExactFilmPixel);
    visit_words("X", pixel, 3, kPixel);
    visit_words("Y", pixel + 12, 3, kPixel);
    visit_words("Z", pixel + 24, 3, kPixel);
    visit_words("weight", pixel + 36, 2, kPixel);
    visit("samples", pixel + 44, kPixel);

    const FilmChannels& layout = contents.channels.layout();
    auto* const sums = reinterpret_cast<Byte*>(contents.channels.all_sums().data());
    const std::size_t sums_stride = sizeof(ExactSum) * static_cast<std::size_t>(layout.sums);
    for (int i = 0; i < layout.sums; ++i) {
        visit_words(fmt::format("sum.{:05}", i), sums + sizeof(ExactSum) * static_cast<std::size_t>(i), 3, sums_stride);
    }
    auto* const squares = reinterpret_cast<Byte*>(contents.channels.all_squares().data());
    const std::size_t squares_stride = sizeof(SquareSum) * static_cast<std::size_t>(layout.squares);
    for (int i = 0; i < layout.squares; ++i) {
        visit_words(fmt::format("square.{}", i), squares + sizeof(SquareSum) * static_cast<std::size_t>(i), 4,
                    squares_stride);
    }
}

}  // namespace emulsion
