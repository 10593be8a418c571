#pragma once
// When a tile of a picture has enough samples: when the standard error of its colour, in CIEDE2000, is below a target.
//
// Samples that decide when to stop must not be in the picture. Where they are, a pixel whose first samples happened to
// be dark and alike is stopped, and one that has just met a firefly goes on until it is diluted: the picture is too
// dark wherever light is skewed (Kirk & Arvo, "Unbiased Sampling Techniques for Image Synthesis", SIGGRAPH 1991; its
// remedy is ours). So two further pictures of few samples, the noise pair, are taken with random numbers of their own.
// They say how noisy the picture is, decide, and are thrown away. How many samples the picture has of a tile is then
// independent of their values, and its expectation is that of any other picture. The price is an eighth more paths, a
// quarter at the first look.
//
// At a look, after n samples of the picture, the noise pair has m each: in a pixel, half the difference of the two is
// an error as that of their mean, of 2 m samples. So few samples are too noisy for a colour difference each; what is
// taken of them are means over many pixels, in which they count by their squares: the covariance of X, Y and Z of a
// sample, relative to the luminance around the pixel, over the tile and over it with its neighbours, of which the worse
// counts. The standard error of the tile is then the root mean square over its pixels of the CIEDE2000 (by the rule of
// spectrum/viewing_conditions.h) that such a covariance over n makes about the mean colour around the pixel.
//
// It is what independent samples have: stratified and low-discrepancy samplers are better, and stop later than they
// need. Light that is so rare that neither of the pair has met it is not in the estimate. Pixels of one tile share the
// decision, those of different tiles don't, and tiles lie on a grid from the film's corner: another crop window,
// another picture.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "film/film.h"

namespace emulsion {

class StoppingRule {
  public:
    /// The first look comes after kFirstLook samples of the picture. The next comes after kSamplesPerLook more, or
    /// after a kShareOfLook-th more, down to a multiple of them: looks take time, and what is soon to be seen is seen.
    static constexpr std::uint64_t kFirstLook = 64, kSamplesPerLook = 16, kShareOfLook = 16;
    [[nodiscard]] static std::uint64_t look_after(std::uint64_t picture_samples) noexcept;
    /// Each of the noise pair has this share of the picture's samples, but never less than kFewestPairSamples.
    static constexpr std::uint64_t kSamplesPerPairSample = 16, kFewestPairSamples = 8;
    /// A tile that has fewer pixels, its neighbours' among them, never stops: that would be by luck.
    static constexpr std::uint64_t kFewestPixels = 64;

    /// \param film      options of the picture's film
    /// \param target    standard error that is low enough, CIEDE2000; finite, > 0
    /// \param tile_px   side of the tiles, counted row by row over the film's sample bounds; >= 1
    /// \throws std::invalid_argument as validate_stopping(), and Film.
    StoppingRule(const FilmOptions& film, double target, int tile_px);

    /// Samples of every pixel that each of the pair must have at a look after `picture_samples` of the picture.
    [[nodiscard]] static std::uint64_t pair_samples(std::uint64_t picture_samples) noexcept;

    /// The noise pair, to be filled; of the picture's options without layers and without a median of means, which so
    /// few samples don't have.
    [[nodiscard]] Film& first() noexcept { return first_; }
    [[nodiscard]] Film& second() noexcept { return second_; }

    /// Stops the tiles whose standard error is at most the target. The pair has pair_samples(picture_samples) in all
    /// tiles that were running; those of stopped ones are never looked at again but for the picture's white.
    /// \param threads 0: one per hardware thread; the result depends on none
    void look(std::uint64_t picture_samples, int threads);

    [[nodiscard]] std::vector<std::size_t> running_tiles() const;
    /// Of every tile, 1 if it has stopped.
    [[nodiscard]] const std::vector<std::uint8_t>& stopped() const noexcept { return stopped_; }

  private:
    /// Sum over pixels of the covariance of one sample's XYZ over the squared luminance around: xx, xy, xz, yy, yz, zz.
    struct Noise {
        std::array<double, 6> sum{};
        std::uint64_t pixels = 0;  ///< those that are black all around, and have none, are not counted
    };
    /// What the pair shows at a look.
    struct Pair {
        Image<XYZd> around, error;  ///< the mean of both over the pixels around, and half of their difference
    };

    [[nodiscard]] Pair shown(int threads) const;
    void measure(std::size_t tile, const Pair& pair, std::uint64_t samples_of_both);
    [[nodiscard]] Noise with_neighbours(std::size_t tile) const;
    [[nodiscard]] PixelBounds pixels_of(std::size_t tile) const noexcept;

    Film first_, second_;
    double target_;
    int tile_px_;
    std::vector<std::uint8_t> stopped_;
    std::vector<Noise> noise_;  // of every tile, as of the last look at it
};

/// That pictures of such a film can be stopped tile by tile.
/// \throws std::invalid_argument naming the field, its value and its range: for a target that isn't finite and > 0, and
/// for splatted filters, which would mix the tiles' numbers of samples at their edges.
void validate_stopping(const FilmOptions& film, double target);

}  // namespace emulsion
