#pragma once
// Sigmoids of quadratic polynomials: smooth, and for colours of every space.
// Source: Jakob & Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling", EG 2019. They look
// coefficients up in a table; so does the second method here, while the first solves for every colour.

#include <string_view>

#include "core/color.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/sigmoid_table.h"
#include "spectrum/spectrum.h"

namespace emulsion {

struct SigmoidUplift {
    static constexpr std::string_view kName = "sigmoid";
    static constexpr std::string_view kHelp = "smooth, solved for exactly; some fifty microseconds a colour";
    bool operator==(const SigmoidUplift&) const = default;
};

struct SigmoidTableUplift {
    static constexpr std::string_view kName = "sigmoid-table";
    static constexpr std::string_view kHelp = "smooth, from a table; sRGB, Rec2020, ACEScg_AP1 and Display_P3";
    bool operator==(const SigmoidTableUplift&) const = default;
};

/// The specification of SigmoidTable: fits a sigmoid to every colour.
class SigmoidFit {
  public:
    explicit SigmoidFit(const ReflectanceRgb& space);

    /// Linear RGB in [0, 1]^3. Greys are constant. All of sRGB is reached; the most saturated colours of wider spaces
    /// lie outside what any reflectance can be, and get a sigmoid with little CIELAB difference (a local minimum).
    [[nodiscard]] SigmoidSpectrum reflectance(const RGBd& rgb) const noexcept;

  private:
    ReflectanceWeights xyz_weights_;
    Matrix3 relative_xyz_from_rgb_;
};

/// SigmoidTable in the form of the other methods.
class TabulatedSigmoid {
  public:
    /// \throws std::invalid_argument for a space without table, naming those that have one.
    explicit TabulatedSigmoid(const ReflectanceRgb& space) : table_(space.space) {}

    /// Linear RGB in [0, 1]^3.
    [[nodiscard]] SigmoidSpectrum reflectance(const RGBd& rgb) const noexcept;

  private:
    SigmoidTable table_;
};

[[nodiscard]] inline SigmoidFit prepare(const SigmoidUplift&, const ReflectanceRgb& space) { return SigmoidFit(space); }
[[nodiscard]] inline TabulatedSigmoid prepare(const SigmoidTableUplift&, const ReflectanceRgb& space) {
    return TabulatedSigmoid(space);
}

}  // namespace emulsion
