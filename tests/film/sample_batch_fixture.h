#pragma once
// Samples as batches have them, and the same one by one.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/random.h"
#include "film/film_options.h"
#include "film/sample_batch.h"

namespace emulsion::testing {

/// `count` samples of each kind, at random in the pixels of `bounds`; every seventh is bad in one way or another.
struct BatchSamples {
    std::size_t wavelengths = 0;
    std::vector<std::int32_t> x, y;
    std::vector<float> x_px, y_px;  // within those pixels
    std::vector<float> weight, lambda_nm, radiance, pdf, triples;

    BatchSamples(const PixelBounds& bounds, std::size_t of_wavelengths, std::size_t count)
        : wavelengths(of_wavelengths) {
        Pcg32 random(7, of_wavelengths);
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        const std::array bad = {std::nanf(""), kInfinity, -kInfinity, -1e9f};
        for (std::size_t i = 0; i < count; ++i) {
            x.push_back(bounds.x0 + static_cast<int>(random.next() % static_cast<std::uint32_t>(bounds.width())));
            y.push_back(bounds.y0 + static_cast<int>(random.next() % static_cast<std::uint32_t>(bounds.height())));
            x_px.push_back(static_cast<float>(x.back()) + random.next_float());
            y_px.push_back(static_cast<float>(y.back()) + random.next_float());
            weight.push_back(random.next_float() < 0.2f ? -0.4f : 1.2f);
            const float size = std::ldexp(1.0f, static_cast<int>(random.next() % 20u) - 10);
            for (std::size_t k = 0; k < wavelengths; ++k) {
                lambda_nm.push_back(350.0f + 490.0f * random.next_float());
                radiance.push_back(size * random.next_float());
                pdf.push_back(random.next_float() < 0.05f ? 0.0f : 0.001f + 0.01f * random.next_float());
            }
            for (int k = 0; k < 3; ++k) triples.push_back(size * random.next_float());
            if (i % 7 != 3) continue;
            triples[3 * i + 1] = bad[i / 7 % bad.size()];
            radiance[wavelengths * i] = bad[i / 7 % bad.size()];
            lambda_nm[wavelengths * i] = 555.0f;
            pdf[wavelengths * i] = 0.01f;
            if (i / 7 % 5 == 4) weight[i] = std::nanf("");
        }
    }

    [[nodiscard]] std::size_t count() const noexcept { return x.size(); }
    [[nodiscard]] BatchPixels pixels() const noexcept { return {x, y, weight}; }
    [[nodiscard]] BatchPlaces places() const noexcept { return {x_px, y_px}; }
    [[nodiscard]] BatchRadiance spectra() const noexcept { return {wavelengths, lambda_nm, radiance, pdf}; }
    [[nodiscard]] XYZ xyz(std::size_t i) const noexcept {
        return {triples[3 * i], triples[3 * i + 1], triples[3 * i + 2]};
    }
    [[nodiscard]] auto xyz_of() const noexcept {
        return [this](std::size_t i) noexcept { return xyz(i); };
    }
    template <int N>
    [[nodiscard]] SampledWavelengths<N> wavelengths_of(std::size_t i) const noexcept {
        SampledWavelengths<N> sample;
        for (std::size_t k = 0; k < wavelengths; ++k) {
            sample.lambda_nm[k] = lambda_nm[wavelengths * i + k];
            sample.pdf[k] = static_cast<float>(wavelengths) / static_cast<float>(N) * pdf[wavelengths * i + k];
        }
        return sample;
    }
    template <int N>
    [[nodiscard]] SampledSpectrum<N> radiance_of(std::size_t i) const noexcept {
        SampledSpectrum<N> sample;
        for (std::size_t k = 0; k < wavelengths; ++k) sample.value[k] = radiance[wavelengths * i + k];
        return sample;
    }
};

}  // namespace emulsion::testing
