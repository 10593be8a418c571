#include "tonemap/histogram_adjustment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace emulsion {

namespace {

constexpr double kTolerance = 0.005;                 // of what is left, trimmed in one pass
constexpr double kSpreadEvenly = 0.001;              // of all
constexpr double kNothing = 1e-5;                    // of all
constexpr double kSpread = std::numbers::ln2 / 5.0;  // of a value to either side, in ln of luminance
constexpr int kParts = 8;  // of a bin: a triangle's ends lie where they lie, and what is trimmed there depends on it

/// A bin of brightness, one of LuminanceHistogram's; the first and the last one are cut off at the ends of the robust
/// range.
struct Bin {
    double low, high;                   // ln of cd/m^2
    double lower_end;                   // not cut off
    std::array<double, kParts> counts;  // in equally wide parts

    [[nodiscard]] double part_width() const noexcept { return (high - low) / kParts; }
    [[nodiscard]] double count() const noexcept { return std::accumulate(counts.begin(), counts.end(), 0.0); }
};

double total_of(std::span<const Bin> bins) noexcept {
    double total = 0.0;
    for (const Bin& bin : bins) total += bin.count();
    return total;
}

void spread_evenly(std::span<Bin> bins) noexcept {
    const double range = bins.back().high - bins.front().low;
    const double density = kSpreadEvenly * total_of(bins) / range;
    for (Bin& bin : bins) {
        for (double& count : bin.counts) count += density * bin.part_width();
    }
}

/// How much of a triangle of area 1 over [-1, 1] lies below u.
double triangle_below(double u) noexcept {
    const double inside = std::clamp(u, -1.0, 1.0);
    return inside < 0.0 ? 0.5 * (1.0 + inside) * (1.0 + inside) : 1.0 - 0.5 * (1.0 - inside) * (1.0 - inside);
}

/// Adds `count` values at `place` (ln of cd/m^2), spread over the bins from `first` on that a triangle about it meets.
void add_spread(std::span<Bin> bins, std::size_t first, double place, double count) noexcept {
    for (Bin& bin : bins.subspan(first)) {
        if (bin.low >= place + kSpread) return;
        double below = triangle_below((bin.low - place) / kSpread);
        for (std::size_t i = 0; i < kParts; ++i) {
            const double end = bin.low + static_cast<double>(i + 1) * bin.part_width();
            const double below_end = triangle_below((end - place) / kSpread);
            bin.counts[i] += count * (below_end - std::exchange(below, below_end));
        }
    }
}

std::vector<Bin> bins_of(const SceneLuminance& luminance) {
    const LuminanceHistogram& histogram = luminance.histogram();
    const double least = luminance.robust_min_cdm2(), most = luminance.robust_max_cdm2();
    std::vector<Bin> bins;
    for (int bin = 0; bin < LuminanceHistogram::kBins; ++bin) {
        const double low = LuminanceHistogram::lower_end(bin), high = LuminanceHistogram::lower_end(bin + 1);
        if (high <= least || low >= most) continue;
        bins.push_back({std::log(std::max(low, least)), std::log(std::min(high, most)), std::log(low), {}});
    }
    const double log_least = bins.front().low, log_most = bins.back().high;
    std::size_t first = 0;  // that the triangle meets
    for (int bin = 0; bin < LuminanceHistogram::kBins; ++bin) {
        const auto count = static_cast<double>(histogram.count(bin));
        if (count == 0.0) continue;
        const double place = std::log(std::clamp(histogram.mean(bin), least, most));
        while (bins[first].high <= place - kSpread) ++first;
        add_spread(bins, first, place, count);
        // What a triangle has past the ends comes back from them.
        if (place < log_least + kSpread) add_spread(bins, 0, 2.0 * log_least - place, count);
        if (place > log_most - kSpread) add_spread(bins, first, 2.0 * log_most - place, count);
    }
    spread_evenly(bins);
    return bins;
}

/// Trims counts to the ceiling, which moves as they shrink. False if (nearly) nothing is left.
bool trim(std::span<Bin> bins, double log_black, double log_range, const ContrastCeiling& ceiling) {
    const double least = kNothing * total_of(bins);
    for (;;) {
        const double total = total_of(bins);
        if (total <= least) return false;
        double below = 0.0, trimmed = 0.0;
        for (Bin& bin : bins) {
            const double here = bin.count();
            const double displayed = std::exp(log_black + log_range * (below + 0.5 * here) / total);
            const double slope = ceiling(std::exp(0.5 * (bin.low + bin.high)), displayed);
            const double most = slope * total * bin.part_width() / log_range;
            for (double& count : bin.counts) count = std::min(count, most);
            below += here;
            trimmed += here - bin.count();
        }
        if (trimmed <= kTolerance * (total - trimmed)) return true;
    }
}

}  // namespace

double BrightnessCurve::displayed_over_luminance(double luminance_cdm2) const noexcept {
    const auto above = std::upper_bound(knots_.begin(), knots_.end(), luminance_cdm2,
                                        [](double value, const Knot& knot) { return value < knot.luminance_cdm2; });
    const Knot& knot = above == knots_.begin() ? knots_.front() : *std::prev(above);
    const double at_knot = knot.displayed_cdm2 / knot.luminance_cdm2;
    if (above == knots_.begin()) return at_knot;
    return at_knot * std::pow(luminance_cdm2 / knot.luminance_cdm2, knot.slope - 1.0);
}

std::optional<BrightnessCurve> adjusted_histogram(const SceneLuminance& luminance, const DisplayRange& display,
                                                  const ContrastCeiling& ceiling) {
    if (!(luminance.robust_min_cdm2() < luminance.robust_max_cdm2())) return std::nullopt;
    std::vector<Bin> bins = bins_of(luminance);
    const double log_range = std::log(display.contrast), log_black = std::log(display.peak_cdm2) - log_range;
    if (!trim(bins, log_black, log_range, ceiling)) return std::nullopt;

    const double total = total_of(bins);
    std::vector<BrightnessCurve::Knot> knots;
    double below = 0.0;
    for (const Bin& bin : bins) {
        const double slope = log_range * bin.count() / total / (bin.high - bin.low);
        const double log_displayed = log_black + log_range * below / total - slope * (bin.low - bin.lower_end);
        knots.push_back({std::exp(bin.lower_end), std::exp(log_displayed), slope});
        below += bin.count();
    }
    return BrightnessCurve(std::move(knots));
}

}  // namespace emulsion
