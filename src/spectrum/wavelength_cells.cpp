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

    const std::size_t cell_count = kWavelengthCells + importance.lines.size();
    const auto even = static_cast<double>(uniform_share);
    const double scale = (1.0 - even) / sum_of(importance);
    add_cells(importance, [&](double value) { return scale * value + even / static_cast<double>(cell_count); });
    lay_out();
    fill_buckets();
}

template <class ShareOf>
void WavelengthCells::add_cells(const WavelengthImportance& importance, const ShareOf& share_of) {
    start_ = {0.0};
    const auto add = [&](double lambda_nm, double value, std::int32_t line) {
        start_.push_back(start_.back() + share_of(value));
        lambda_nm_.push_back(lambda_nm);
        cells_.push_back({0.0, 0.0, 0.0, 0.0f, line});
    };
    const std::vector<std::size_t> order = by_wavelength(importance.lines);
    auto next = order.begin();
    for (std::size_t nm = 0; nm < kWavelengthCells; ++nm) {
        const double start_nm = kMinWavelength_nm + static_cast<double>(nm);
        add(start_nm, importance.per_nm[nm], kNoLine);
        // The last nanometre takes the line at its end too.
        const bool is_last = nm + 1 == kWavelengthCells;
        for (; next != order.end() && (is_last || importance.lines[*next].lambda_nm < start_nm + 1.0); ++next) {
            const LineImportance& line = importance.lines[*next];
            add(line.lambda_nm, line.importance, static_cast<std::int32_t>(*next));
        }
    }
    mass_.resize(order.size());
}

void WavelengthCells::lay_out() {
    // The sum is 1 but for rounding.
    const double total = start_.back();
    for (double& start : start_) start /= total;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        Cell& cell = cells_[i];
        const double probability = start_[i + 1] - start_[i];
        cell.end = start_[i + 1];
        cell.slope_nm = cell.line == kNoLine ? 1.0 / probability : 0.0;
        cell.at_zero_nm = lambda_nm_[i] - start_[i] * cell.slope_nm;
        cell.pdf = static_cast<float>(probability);
        if (cell.line == kNoLine) {
            density_.push_back(probability);
        } else {
            mass_[static_cast<std::size_t>(cell.line)] = probability;
        }
    }
}

void WavelengthCells::fill_buckets() {
    double least = 1.0;
    for (std::size_t i = 0; i < cells_.size(); ++i) least = std::min(least, start_[i + 1] - start_[i]);
    // A hair more than 1/M, so that rounding can't put two ends into one bucket.
    std::size_t count = 1;
    while (least * static_cast<double>(count) < 1.0 + 1e-9) count *= 2;
    buckets_ = static_cast<double>(count);
    std::size_t cell = 0;
    for (std::size_t bucket = 0; bucket < count; ++bucket) {
        while (start_[cell + 1] <= static_cast<double>(bucket) / buckets_) ++cell;
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
