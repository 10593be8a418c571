#pragma once
// Glasses: index of refraction by Sellmeier's formula, at any wavelength of its range.

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace emulsion {

/// n^2 = 1 + sum of b_j L^2 / (L^2 - c_j), with L in micrometres.
/// Source: SCHOTT optical glass catalogue (2017); fused silica: Malitson, JOSA 55 (1965).
struct SellmeierGlass {
    std::string name;               ///< "N_BK7"
    std::array<double, 3> b{};      ///< dimensionless
    std::array<double, 3> c_um2{};  ///< square micrometres
    double lambda_min_nm = 0.0;     ///< the formula was fitted from here
    double lambda_max_nm = 0.0;     ///< to here
    double nd = 0.0;                ///< catalogued index at 587.5618 nm (helium d), for checking
    double vd = 0.0;                ///< catalogued Abbe number, (nd - 1) / (nF - nC), for checking
    bool operator==(const SellmeierGlass&) const = default;
};

/// Every glass of data/glasses.csv.
[[nodiscard]] const std::vector<SellmeierGlass>& sellmeier_glasses();

/// A glass by its catalogue name. Case makes no difference, nor do '-', '_' and the space for one another.
/// \throws std::invalid_argument for an unknown name, listing those that exist, nearest first.
[[nodiscard]] const SellmeierGlass& sellmeier_glass(std::string_view name);

/// Index of refraction, by the formula.
/// \throws std::invalid_argument for a wavelength outside lambda_min_nm to lambda_max_nm.
[[nodiscard]] double index_of_refraction(const SellmeierGlass& glass, double lambda_nm);

/// The formula alone, also where the catalogue doesn't vouch for it: real only away from the resonances, which lie
/// below 250 nm and above 9800 nm for the glasses here.
[[nodiscard]] double extrapolated_index(const SellmeierGlass& glass, double lambda_nm) noexcept;

}  // namespace emulsion
