#include "pathtracer/sample_sequence.h"

#include <cmath>
#include <variant>

namespace emulsion {

namespace {

int count_of(const IndependentSampler& sampler) noexcept { return sampler.samples_per_pixel; }
int count_of(const StratifiedSampler& sampler) noexcept { return sampler.x_samples * sampler.y_samples; }
int count_of(const PaddedSobolSampler& sampler) noexcept { return sampler.samples_per_pixel; }

Sampler with_count(IndependentSampler sampler, int count) noexcept {
    sampler.samples_per_pixel = count;
    return sampler;
}
Sampler with_count(PaddedSobolSampler sampler, int count) noexcept {
    sampler.samples_per_pixel = count;
    return sampler;
}
Sampler with_count(StratifiedSampler sampler, int count) noexcept {
    sampler.x_samples = static_cast<int>(std::sqrt(static_cast<double>(count)));
    while (count % sampler.x_samples != 0) --sampler.x_samples;
    sampler.y_samples = count / sampler.x_samples;
    return sampler;
}

std::string text_of(const IndependentSampler&) { return "independent"; }
std::string text_of(const PaddedSobolSampler&) { return "padded-sobol"; }
std::string text_of(const StratifiedSampler& sampler) {
    return "stratified:x=" + std::to_string(sampler.x_samples) + ",y=" + std::to_string(sampler.y_samples) +
           ",jitter=" + (sampler.jitter ? "yes" : "no");
}

}  // namespace

std::string to_text(const Sampler& sampler) {
    return std::visit([](const auto& s) { return text_of(s); }, sampler);
}

int samples_per_pixel(const Sampler& sampler) noexcept {
    return std::visit([](const auto& s) { return count_of(s); }, sampler);
}

Sampler with_samples_per_pixel(const Sampler& sampler, int count) noexcept {
    // Strata that the scene has chosen stay as they are.
    if (count == samples_per_pixel(sampler)) return sampler;
    return std::visit([count](const auto& s) { return with_count(s, count); }, sampler);
}

}  // namespace emulsion
