#pragma once
// Wavelengths for scenes with lines without width (delta lines), which no density can hit: each wavelength is drawn
// either from the lines, with a mass each, or from the continuum, with a density in 1/nm.
//
// How a renderer uses it. The lines of all its lights have one numbering, that of wavelength_importance(the lights'
// sum). A light gives the radiance of its continuum L(lambda), in W m^-2 sr^-1 nm^-1, and that of each line j, P_j in
// W m^-2 sr^-1 (line_powers(light, importance)). On a path, reflectances and the like are taken at lambda_nm[i] as
// ever. Where the path meets a light,
//     line[i] == kNoLine:   radiance[i] = throughput[i] * L(lambda_nm[i])       and P counts for nothing;
//     line[i] == j:         radiance[i] = throughput[i] * P_j                   and L counts for nothing.
// XYZ is then estimated by the formula that holds without lines, (1/N) sum_i radiance[i] / pdf[i] * xyzbar(lambda_i):
// pdf[i] is the mass for a line, and P_j / mass has the unit of L / density. So a film needs no change.
//
// Why L counts for nothing on a line: one wavelength alone holds none of the continuum, and a density almost never hits
// a line. So the balance heuristic in its one-sample form (Veach & Guibas, "Optimally Combining Sampling Techniques for
// Monte Carlo Rendering", SIGGRAPH 1995) gives all the weight to the technique that made the sample, and is this
// mixture. Lines of some width, however narrow, are continuum: their nanometres get their share of the density. Of a
// Gaussian much narrower than a nanometre few samples hit anything, though: a renderer takes it from its SpectrumTable,
// which spreads it over the nanometre.
//
// The choice between lines and continuum is stratified: lines and nanometres lie in the order of wavelength on one axis
// of u, each as long as its probability, and the N numbers of a path are spread over it. By rotation, a line of mass m
// is drawn floor(m N) to ceil(m N) times. Where probability follows importance, every sample carries the same X + Y +
// Z, and it makes no odds how many of them are lines.

#include <array>
#include <cstdint>

#include "spectrum/sampled_spectrum.h"
#include "spectrum/wavelength_cells.h"
#include "spectrum/wavelength_pdf.h"

namespace emulsion {

/// N wavelengths, some of which may be lines. A plain SampledWavelengths for all who don't ask.
template <int N>
struct SampledLineWavelengths : SampledWavelengths<N> {
    /// Which line lambda_nm[i] is, by its index in the importance; pdf[i] is then its mass, without unit. Or kNoLine.
    std::array<std::int32_t, N> line{};
};

/// A mixture of masses on lines and a density elsewhere.
class LineWavelengthPdf {
  public:
    /// Every line and every nanometre has at least uniform_share / (470 + the number of lines).
    /// \throws std::invalid_argument as WavelengthCells does.
    explicit LineWavelengthPdf(const WavelengthImportance& importance, float uniform_share = kDefaultUniformShare)
        : cells_(importance, uniform_share) {}

    [[nodiscard]] WavelengthCells::ExactSample exact(double u) const noexcept { return cells_.exact(u); }
    [[nodiscard]] WavelengthCells::Sample sample(double u) const noexcept { return cells_.sample(u); }
    /// Of the continuum: integrates to 1 minus all masses. At a whole nanometre, that above (at the last, below).
    [[nodiscard]] double pdf(double lambda_nm) const noexcept { return cells_.pdf(lambda_nm); }
    /// Of line `line` < line_count().
    [[nodiscard]] double mass(std::size_t line) const noexcept { return cells_.mass(line); }
    [[nodiscard]] std::size_t line_count() const noexcept { return cells_.line_count(); }

  private:
    WavelengthCells cells_;
};

}  // namespace emulsion
