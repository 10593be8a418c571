#pragma once
// The random numbers of one path: a pure function of seed, pixel, sample index and the order in which they are drawn.

#include <array>
#include <cstdint>
#include <string>

#include "core/low_discrepancy.h"
#include "core/random.h"
#include "pathtracer/scene.h"

namespace emulsion {

class SampleSequence {
  public:
    SampleSequence() = default;

    /// The sequence of sample `index` >= 0 of pixel (x, y).
    SampleSequence(const Sampler& sampler, std::uint64_t seed, int x, int y, int index) noexcept
        : kind_(static_cast<Kind>(sampler.index())), index_(static_cast<std::uint32_t>(index)) {
        const auto pixel = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) |
                           static_cast<std::uint64_t>(static_cast<std::uint32_t>(x));
        pixel_seed_ = hash_combine(hash_combine(0, seed), pixel);
        random_ = Pcg32(hash_combine(pixel_seed_, index_));
        if (const auto* stratified = std::get_if<StratifiedSampler>(&sampler)) {
            x_strata_ = static_cast<std::uint32_t>(stratified->x_samples);
            y_strata_ = static_cast<std::uint32_t>(stratified->y_samples);
            jitter_ = stratified->jitter;
        }
    }

    /// The next number, in [0, 1).
    [[nodiscard]] float next_1d() noexcept {
        switch (kind_) {
            case Kind::independent:
                return random_.next_float();
            case Kind::stratified:
                return stratified_1d();
            case Kind::padded_sobol:
                return scrambled_sobol_1d(index_, next_dimension_seed());
        }
        return 0.0f;
    }

    /// The next number with 48 bits instead of 24, for picking among many.
    [[nodiscard]] double next_1d_fine() noexcept {
        const auto high = static_cast<double>(next_1d());
        return high + static_cast<double>(random_.next_float()) * 0x1p-24;
    }

    /// The next pair, each in [0, 1).
    [[nodiscard]] std::array<float, 2> next_2d() noexcept {
        switch (kind_) {
            case Kind::independent: {
                const float first = random_.next_float();
                return {first, random_.next_float()};
            }
            case Kind::stratified:
                return stratified_2d();
            case Kind::padded_sobol:
                return scrambled_sobol_2d(index_, next_dimension_seed());
        }
        return {};
    }

  private:
    // In the order of the alternatives of Sampler.
    enum class Kind : std::uint8_t { independent, stratified, padded_sobol };
    static_assert(std::variant_size_v<Sampler> == 3);

    std::uint64_t next_dimension_seed() noexcept { return hash_combine(pixel_seed_, ++dimension_); }
    float jitter() noexcept { return jitter_ ? random_.next_float() : 0.5f; }

    /// Sample indices beyond the strata go round them again, in another order.
    std::uint32_t stratum(std::uint32_t count) noexcept {
        const auto seed = static_cast<std::uint32_t>(hash_combine(next_dimension_seed(), index_ / count));
        return permuted(index_ % count, count, seed);
    }
    static float place(std::uint32_t cell, float offset, std::uint32_t count) noexcept {
        return std::min((static_cast<float>(cell) + offset) / static_cast<float>(count), 0x1.fffffep-1f);
    }
    float stratified_1d() noexcept {
        const std::uint32_t count = x_strata_ * y_strata_;
        return place(stratum(count), jitter(), count);
    }
    std::array<float, 2> stratified_2d() noexcept {
        const std::uint32_t cell = stratum(x_strata_ * y_strata_);
        const float x = place(cell % x_strata_, jitter(), x_strata_);
        return {x, place(cell / x_strata_, jitter(), y_strata_)};
    }

    Pcg32 random_;
    std::uint64_t pixel_seed_ = 0;
    Kind kind_ = Kind::independent;
    bool jitter_ = true;
    std::uint32_t index_ = 0, dimension_ = 0, x_strata_ = 1, y_strata_ = 1;
};

/// The number of samples per pixel that the sampler was asked for.
[[nodiscard]] int samples_per_pixel(const Sampler& sampler) noexcept;

/// What decides the numbers of a sample: "independent", "stratified:x=4,y=4,jitter=yes", "padded-sobol". The number of
/// samples is part of it only where it matters: the first 16 of 64 independent samples are those of 16.
[[nodiscard]] std::string to_text(const Sampler& sampler);

/// The same sampler for another number of samples per pixel, >= 1; strata are made as square as the number allows.
[[nodiscard]] Sampler with_samples_per_pixel(const Sampler& sampler, int count) noexcept;

}  // namespace emulsion
