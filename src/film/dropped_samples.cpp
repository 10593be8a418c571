#include "film/dropped_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace emulsion {

namespace {

/// Reading order first; the rest makes the order total, so that neither the order of samples nor that of merges shows.
auto order_of(const DroppedSample& sample) noexcept {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    return std::make_tuple(sample.y_px, sample.x_px, sample.kind, bits(sample.value.x), bits(sample.value.y),
                           bits(sample.value.z), bits(sample.weight));
}

bool is_before(const DroppedSample& a, const DroppedSample& b) noexcept { return order_of(a) < order_of(b); }

const char* name_of(DroppedKind kind) noexcept {
    switch (kind) {
        case DroppedKind::nan:
            return "not a number";
        case DroppedKind::infinite:
            return "infinite";
        case DroppedKind::negative_luminance:
            return "negative luminance";
    }
    return "";
}

}  // namespace

DroppedKind kind_of_dropped(std::span<const float> numbers) noexcept {
    if (std::any_of(numbers.begin(), numbers.end(), [](float v) { return std::isnan(v); })) return DroppedKind::nan;
    if (std::any_of(numbers.begin(), numbers.end(), [](float v) { return std::isinf(v); })) {
        return DroppedKind::infinite;
    }
    return DroppedKind::negative_luminance;
}

std::string to_string(const DroppedSample& sample) {
    std::ostringstream text;
    text << "pixel (" << sample.x_px << ", " << sample.y_px << "): XYZ (" << sample.value.x << ", " << sample.value.y
         << ", " << sample.value.z << "), weight " << sample.weight << ": " << name_of(sample.kind);
    return text.str();
}

void DroppedSamples::add(const DroppedSample& sample) noexcept {
    ++counts_[static_cast<std::size_t>(sample.kind)];
    if (first_count_ < kReported) {
        ++first_count_;
    } else if (!is_before(sample, first_.back())) {
        return;
    }
    std::size_t place = first_count_ - 1;
    for (; place > 0 && is_before(sample, first_[place - 1]); --place) first_[place] = first_[place - 1];
    first_[place] = sample;
}

void DroppedSamples::merge(const DroppedSamples& other) noexcept {
    for (std::size_t kind = 0; kind < counts_.size(); ++kind) counts_[kind] += other.counts_[kind];

    std::array<DroppedSample, 2 * kReported> both{};
    auto* end = std::copy_n(first_.begin(), first_count_, both.begin());
    end = std::copy_n(other.first_.begin(), other.first_count_, end);
    std::sort(both.begin(), end, is_before);
    first_count_ = std::min(kReported, first_count_ + other.first_count_);
    std::copy_n(both.begin(), first_count_, first_.begin());
}

DroppedSamples DroppedSamples::restored(const std::array<std::uint64_t, 3>& counts,
                                        std::span<const DroppedSample> first) {
    DroppedSamples dropped;
    for (const DroppedSample& sample : first) dropped.add(sample);
    const bool fits = first.size() <= kReported && std::is_sorted(first.begin(), first.end(), is_before) &&
                      std::equal(dropped.counts_.begin(), dropped.counts_.end(), counts.begin(), std::less_equal<>());
    if (!fits) {
        throw std::invalid_argument("dropped samples: " + std::to_string(first.size()) +
                                    " are reported, expected at most " + std::to_string(kReported) +
                                    " in reading order, and no more of a kind than are counted");
    }
    dropped.counts_ = counts;
    return dropped;
}

bool operator==(const DroppedSamples& a, const DroppedSamples& b) noexcept {
    return a.counts_ == b.counts_ &&
           std::equal(a.first().begin(), a.first().end(), b.first().begin(), b.first().end(),
                      [](const DroppedSample& x, const DroppedSample& y) { return order_of(x) == order_of(y); });
}

}  // namespace emulsion
