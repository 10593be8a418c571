#pragma once
// A strategy made ready for the light of one scene, and the drawing itself.

#include <array>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "core/visit.h"
#include "spectrum/wavelength_lines.h"
#include "spectrum/wavelength_sampling.h"
#include "spectrum/wavelength_strategy.h"
#include "spectrum/wavelength_table.h"

namespace emulsion {

/// An arrangement of numbers and what they go through.
template <class ArrangementT, class PdfT>
struct ArrangedPdf {
    using Arrangement = ArrangementT;
    PdfT pdf;
};

/// A strategy's ready forms, in the order of WavelengthStrategy.
using WavelengthSampler = std::variant<
    ArrangedPdf<HeroArrangement, VisibleWavelengthPdf>, ArrangedPdf<IndependentArrangement, UniformWavelengthPdf>,
    ArrangedPdf<StratifiedArrangement, UniformWavelengthPdf>, ArrangedPdf<HeroArrangement, UniformWavelengthPdf>,
    ArrangedPdf<HeroArrangement, TabulatedWavelengthPdf>, ArrangedPdf<HeroArrangement, LineWavelengthPdf>>;

/// `light`: of all lights of the scene together. HeroIlluminant ignores its lines, and strategies that know nothing of
/// the light all of it.
/// \throws std::invalid_argument for a parameter out of its range and, where the light is used, as
/// validate(WavelengthImportance) does.
[[nodiscard]] WavelengthSampler prepare(const WavelengthStrategy& strategy, const WavelengthImportance& light);

/// Draws N wavelengths. `next_u` gives uniform numbers in [0, 1) and doesn't throw; it is called once by the hero
/// strategies, N times by the others. pdf[i] is a mass where line[i] says so (wavelength_lines.h), which only HeroLines
/// makes. A renderer's inner loop that has settled on one strategy calls hero_wavelengths on its density: that carries
/// no lines.
template <int N, UniformSource Source>
[[nodiscard]] SampledLineWavelengths<N> sample_wavelengths(const WavelengthSampler& sampler, Source&& next_u) noexcept {
    return visit_noexcept(
        [&next_u]<class Arrangement, class Pdf>(const ArrangedPdf<Arrangement, Pdf>& arranged) {
            SampledLineWavelengths<N> wavelengths;
            if constexpr (std::is_same_v<Pdf, LineWavelengthPdf>) {
                wavelengths = wavelengths_at(arranged.pdf, Arrangement::template numbers<N>(next_u));
            } else {
                static_cast<SampledWavelengths<N>&>(wavelengths) =
                    wavelengths_at(arranged.pdf, Arrangement::template numbers<N>(next_u));
                wavelengths.line.fill(kNoLine);
            }
            return wavelengths;
        },
        sampler);
}

/// The double-precision twin, from the same numbers: sample_wavelengths is within 1e-4 nm of it, and within 1e-6 in
/// pdf, relative.
template <int N, UniformSource Source>
[[nodiscard]] std::array<WavelengthCells::ExactSample, N> sample_wavelengths_reference(const WavelengthSampler& sampler,
                                                                                       Source&& next_u) noexcept {
    return visit_noexcept(
        [&next_u]<class Arrangement, class Pdf>(const ArrangedPdf<Arrangement, Pdf>& arranged) {
            const WavelengthNumbers<N> numbers = Arrangement::template numbers<N>(next_u);
            std::array<WavelengthCells::ExactSample, N> samples{};
            for (std::size_t i = 0; i < N; ++i) {
                const auto sample = arranged.pdf.exact(numbers[i]);
                samples[i] = {sample.lambda_nm, sample.pdf, kNoLine};
                if constexpr (std::is_same_v<Pdf, LineWavelengthPdf>) samples[i].line = sample.line;
            }
            return samples;
        },
        sampler);
}

/// The density at a wavelength, 1/nm, of one of the N picked at random; 0 outside the range. Without lines: it then
/// integrates to 1 minus their masses.
[[nodiscard]] double wavelength_pdf(const WavelengthSampler& sampler, double lambda_nm) noexcept;

/// The mass of a line of the light that the sampler was prepared for; 0 for strategies that see no lines.
[[nodiscard]] double line_mass(const WavelengthSampler& sampler, std::size_t line) noexcept;

}  // namespace emulsion
