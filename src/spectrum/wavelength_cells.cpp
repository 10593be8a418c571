#include "spectrum/wavelength_cells.h"

#include <algorithm>
#include <numeric>

namespace emulsion {

namespace {

// The numbers of the lines by wavelength.
std::vector<std::size_t> by_wavelength(const std::vector<LineImportance>& lines) {
    std::vector<std::size_t> order(lines.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return lines[a].lambda_nm < lines[b].lambda_nm; });
    return order;
}

double sum_of(const WavelengthImportance& importance) {
    double sum = std::accumulate(importance.per_nm.begin(), importance.per_nm.end(), 0.0);
    for (const LineImportance& line : importance.lines) sum += line.importance;
    return sum;
}

}  // namespace

WavelengthCells::WavelengthCells(const WavelengthImportance& importance, float uniform_share) {
    validate(importance);
    check_range(uniform_share, kUniformShareRange, "wavelengths: uniform_share");

    // The cells in the order of wavelength: each nanometre, then the lines in it.
    const std::vector<std::size_t> order = by_wavelength(importance.lines);
    const double cell_count = static_cast<double>(kWavelengthCells + order.size());
    const auto even = static_cast<double>(uniform_share);
    const double scale = (1.0 - even) / sum_of(importance);
    const auto share_of = [&](double value) { return scale * value + even / cell_count; };
    std::vector<double> share;
    std::size_t next = 0;
    for (std::size_t nm = 0; nm < kWavelengthCells; ++nm) {
        const double start_nm = kMinWavelength_nm + static_cast<double>(nm);
        share.push_back(share_of(importance.per_nm[nm]));
        lambda_nm_.push_back(start_nm);
        cells_.push_back({0.0, 0.0, 0.0, 0.0f, kNoLine});
        const bool last = nm + 1 == kWavelengthCells;
        for (; next < order.size() && (last || importance.lines[order[next]].lambda_nm < start_nm + 1.0); ++next) {
            const LineImportance& line = importance.lines[order[next]];
            share.push_back(share_of(line.importance));
            lambda_nm_.push_back(line.lambda_nm);
            cells_.push_back({0.0, 0.0, 0.0, 0.0f, static_cast<std::int32_t>(order[next])});
        }
    }

    // Their intervals of u: the sum is 1 but for rounding, and divided out.
    start_.assign(share.size() + 1, 0.0);
    std::partial_sum(share.begin(), share.end(), start_.begin() + 1);
    const double total = start_.back();
    for (double& start : start_) start /= total;
    density_.resize(kWavelengthCells);
    mass_.resize(order.size());
    std::size_t nm = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        Cell& cell = cells_[i];
        const double probability = start_[i + 1] - start_[i];
        cell.end = start_[i + 1];
        cell.slope_nm = cell.line == kNoLine ? 1.0 / probability : 0.0;
        cell.at_zero_nm = lambda_nm_[i] - start_[i] * cell.slope_nm;
        cell.pdf = static_cast<float>(probability);
        if (cell.line == kNoLine) {
            density_[nm++] = probability;
        } else {
            mass_[static_cast<std::size_t>(cell.line)] = probability;
        }
    }
    fill_buckets();
}

void WavelengthCells::fill_buckets() {
    double least = 1.0;
    for (std::size_t i = 0; i < cells_.size(); ++i) least = std::min(least, start_[i + 1] - start_[i]);
    // A hair more than 1/M, so that rounding can't put two ends into one bucket.
    while (least * buckets_ < 1.0 + 1e-9) buckets_ *= 2.0;
    std::size_t cell = 0;
    for (double bucket = 0.0; bucket < buckets_; bucket += 1.0) {
        while (start_[cell + 1] <= bucket / buckets_) ++cell;
        first_cell_.push_back(static_cast<std::uint16_t>(cell));
    }
}

WavelengthCells::ExactSample WavelengthCells::exact(double u) const noexcept {
    const auto above = std::upper_bound(start_.begin() + 1, start_.end() - 1, u);
    const auto i = static_cast<std::size_t>(above - start_.begin()) - 1;
    const double probability = start_[i + 1] - start_[i];
    const std::int32_t line = cells_[i].line;
    if (line != kNoLine) return {lambda_nm_[i], probability, line};
    return {lambda_nm_[i] + (u - start_[i]) / probability, probability, kNoLine};
}

double WavelengthCells::pdf(double lambda_nm) const noexcept {
    if (!(lambda_nm >= kMinWavelength_nm && lambda_nm <= kMaxWavelength_nm)) return 0.0;
    const auto cell = static_cast<std::size_t>(lambda_nm - kMinWavelength_nm);
    return density_[std::min(cell, kWavelengthCells - 1)];
}

}  // namespace emulsion
