#include "tonemap/histogram_adjustment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <span>

namespace emulsion {

namespace {

constexpr double kTolerance = 0.005;                 // of what is left, trimmed in one pass
constexpr double kSpreadEvenly = 0.001;              // of all
constexpr double kNothing = 1e-5;                    // of all
constexpr double kSpread = std::numbers::ln2 / 8.0;  // of a value to either side, in ln of luminance

/// A bin of brightness, one of LuminanceHistogram's; the first and the last one are cut off at the ends of the robust
/// range.
struct Bin {
    double low, high;  // ln of cd/m^2
    double count;
    double lower_end;  // not cut off, or only where that would be 0
};

double total_of(const std::vector<Bin>& bins) noexcept {
    double total = 0.0;
    for (const Bin& bin : bins) total += bin.count;
    return total;
}

void spread_evenly(std::vector<Bin>& bins) noexcept {
    const double range = bins.back().high - bins.front().low;
    const double density = kSpreadEvenly * total_of(bins) / range;
    for (Bin& bin : bins) bin.count += density * (bin.high - bin.low);
}

/// How much of a triangle of area 1 over [-1, 1] lies below u.
double triangle_below(double u) noexcept {
    const double inside = std::clamp(u, -1.0, 1.0);
    return inside < 0.0 ? 0.5 * (1.0 + inside) * (1.0 + inside) : 1.0 - 0.5 * (1.0 - inside) * (1.0 - inside);
}

/// Adds `count` values at `place` (ln of cd/m^2), spread over the bins from `first` on that a triangle about it meets.
void add_spread(std::span<Bin> bins, std::size_t first, double place, double count) noexcept {
    const auto below = [&](double end) { return triangle_below((end - place) / kSpread); };
    for (Bin& bin : bins.subspan(first)) {
        if (bin.low >= place + kSpread) return;
        bin.count += count * (below(bin.high) - below(bin.low));
    }
}

std::vector<Bin> bins_of(const SceneLuminance& luminance) {
    const LuminanceHistogram& histogram = luminance.histogram();
    const double least = luminance.robust_min_cdm2(), most = luminance.robust_max_cdm2();
    std::vector<Bin> bins;
    for (int bin = 0; bin < LuminanceHistogram::kBins; ++bin) {
        const double low = LuminanceHistogram::lower_end(bin), high = LuminanceHistogram::lower_end(bin + 1);
        if (high <= least || low >= most) continue;
        bins.push_back({std::log(std::max(low, least)), std::log(std::min(high, most)), 0.0,
                        low > 0.0 ? std::log(low) : std::log(least)});
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
bool trim(std::vector<Bin>& bins, double log_black, double log_range, const ContrastCeiling& ceiling) {
    const double least = kNothing * total_of(bins);
    for (;;) {
        const double total = total_of(bins);
        if (total <= least) return false;
        double below = 0.0, trimmed = 0.0;
        for (Bin& bin : bins) {
            const double displayed = std::exp(log_black + log_range * (below + 0.5 * bin.count) / total);
            const double slope = ceiling(std::exp(0.5 * (bin.low + bin.high)), displayed);
            const double most = slope * total * (bin.high - bin.low) / log_range;
            below += bin.count;
            trimmed += std::max(bin.count - most, 0.0);
            bin.count = std::min(bin.count, most);
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
        const double slope = log_range * bin.count / total / (bin.high - bin.low);
        const double log_displayed = log_black + log_range * below / total - slope * (bin.low - bin.lower_end);
        knots.push_back({std::exp(bin.lower_end), std::exp(log_displayed), slope});
        below += bin.count;
    }
    return BrightnessCurve(std::move(knots));
}

}  // namespace emulsion
