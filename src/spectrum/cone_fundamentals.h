#pragma once
// What the long-, medium- and short-wavelength cones of the eye take in: functions lbar, mbar, sbar of the wavelength,
// dimensionless, for light measured as energy (not as quanta) at the cornea, each with its peak scaled to 1.

#include <string>
#include <vector>

#include "core/matrix3.h"

namespace emulsion {

/// The three cones at one wavelength.
struct ConeSensitivities {
    double l = 0.0, m = 0.0, s = 0.0;
    bool operator==(const ConeSensitivities&) const = default;
};

[[nodiscard]] constexpr ConeSensitivities operator+(const ConeSensitivities& a, const ConeSensitivities& b) noexcept {
    return {a.l + b.l, a.m + b.m, a.s + b.s};
}
[[nodiscard]] constexpr ConeSensitivities operator*(double scale, const ConeSensitivities& a) noexcept {
    return {scale * a.l, scale * a.m, scale * a.s};
}

/// Cone fundamentals at first_nm, first_nm + 1, ...; straight lines between them and 0 outside.
struct ConeFundamentals {
    std::string name;
    int first_nm = 0;
    std::vector<ConeSensitivities> value;  ///< at least two

    [[nodiscard]] int last_nm() const noexcept { return first_nm + static_cast<int>(value.size()) - 1; }
};

/// Stockman and Sharpe's for 2 degrees, 390-830 nm. sbar is not tabulated above 615 nm, and is 0 there.
/// Source: Stockman & Sharpe, Vision Research 40 (2000); CIE 170-1:2006.
[[nodiscard]] const ConeFundamentals& stockman_sharpe_2deg();

/// (lbar, mbar, sbar) at one wavelength; 0 outside the table.
[[nodiscard]] ConeSensitivities eval(const ConeFundamentals& fundamentals, double lambda_nm) noexcept;

/// XYZ of the CIE 2015 2 degree observer (cie_2015_2deg; no other) from the three cones' responses. The tabulated
/// functions fulfil it to the last of their six or seven digits. Source: CIE 170-2:2015; CIE 015:2018.
[[nodiscard]] Matrix3 xyz_2015_from_stockman_sharpe() noexcept;

}  // namespace emulsion
