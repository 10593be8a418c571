#pragma once
// The distribution behind wavelength_table.h and wavelength_lines.h: a density that is constant on each whole
// nanometre, and masses on single wavelengths (lines). In the order of wavelength, each is a cell that owns an interval
// of u as long as its probability; in it, lambda is a straight line in u: of slope 1/density for a nanometre, and level
// for a line.
//
// Which cell u falls into is found without a search. Every cell is given at least 1/M, M a power of two, so that a
// bucket [k/M, (k+1)/M) meets at most two cells: a table by k gives the first, one comparison tells whether it is the
// next. Source: the cut points of Chen & Asau, "On Generating Random Variates from an Empirical Distribution", AIIE
// Transactions 6(2), 1974, there with a search behind the table.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/parameters.h"
#include "core/units.h"
#include "spectrum/wavelength_importance.h"

namespace emulsion {

/// The line of a wavelength that is on none.
inline constexpr std::int32_t kNoLine = -1;

/// The share of the samples that is spread evenly over all cells, whatever the importance: range and default. At the
/// default M is 8192, and the table by bucket is 16 KB; at the least it is 32768.
inline constexpr ParameterRange kUniformShareRange = {1.0 / 64.0, 1.0};
inline constexpr float kDefaultUniformShare = 1.0f / 16.0f;

class WavelengthCells {
  public:
    /// A cell's probability: (1 - uniform_share) * its importance / the sum + uniform_share / the number of cells.
    /// \throws std::invalid_argument as validate(WavelengthImportance) does, and for a share outside
    /// kUniformShareRange.
    WavelengthCells(const WavelengthImportance& importance, float uniform_share);

    /// pdf: the density in 1/nm where line is kNoLine, and the mass of the line elsewhere.
    struct Sample {
        float lambda_nm, pdf;
        std::int32_t line;
    };
    struct ExactSample {
        double lambda_nm, pdf;
        std::int32_t line;
    };

    /// u in [0, 1). Without branches.
    [[nodiscard]] Sample sample(double u) const noexcept {
        const auto bucket = static_cast<std::size_t>(static_cast<std::int32_t>(u * buckets_));
        std::size_t i = first_cell_[bucket];
        i += static_cast<std::size_t>(u >= cells_[i].end);
        const Cell& cell = cells_[i];
        return {static_cast<float>(cell.at_zero_nm + u * cell.slope_nm), cell.pdf, cell.line};
    }

    /// The specification of sample(): by binary search, in double precision.
    [[nodiscard]] ExactSample exact(double u) const noexcept;

    /// The density of the continuum, 1/nm; 0 outside the range. At a whole nanometre, that above (at the last, below).
    [[nodiscard]] double pdf(double lambda_nm) const noexcept;
    /// The mass of a line, by its index in the importance.
    [[nodiscard]] double mass(std::size_t line) const noexcept { return mass_[line]; }
    [[nodiscard]] std::size_t line_count() const noexcept { return mass_.size(); }

  private:
    struct Cell {
        double end;         // of its interval of u
        double at_zero_nm;  // lambda = at_zero_nm + u * slope_nm
        double slope_nm;
        float pdf;
        std::int32_t line;
    };

    // In the order of wavelength: each nanometre, then the lines in it. share_of(importance): a cell's probability.
    template <class ShareOf>
    void add_cells(const WavelengthImportance& importance, const ShareOf& share_of);
    // Cells' intervals of u and their straight lines.
    void lay_out();
    void fill_buckets();

    double buckets_ = 1.0;                   // M
    std::vector<Cell> cells_;                // by u
    std::vector<std::uint16_t> first_cell_;  // by bucket: the cell of the bucket's start
    // For the specification: the interval of cell i is [start_[i], start_[i + 1]).
    std::vector<double> start_, lambda_nm_;
    std::vector<double> density_;  // by nanometre
    std::vector<double> mass_;     // by line
};

}  // namespace emulsion
