#include "spectrum/wavelength_sampler.h"

#include "core/named_value.h"

namespace emulsion {

namespace {

using Light = WavelengthImportance;

ArrangedPdf<HeroArrangement, VisibleWavelengthPdf> ready(const HeroVisible&, const Light&) { return {}; }
ArrangedPdf<IndependentArrangement, UniformWavelengthPdf> ready(const IndependentUniform&, const Light&) { return {}; }
ArrangedPdf<StratifiedArrangement, UniformWavelengthPdf> ready(const StratifiedUniform&, const Light&) { return {}; }
ArrangedPdf<HeroArrangement, UniformWavelengthPdf> ready(const HeroUniform&, const Light&) { return {}; }

ArrangedPdf<HeroArrangement, TabulatedWavelengthPdf> ready(const HeroIlluminant& strategy, const Light& light) {
    return {TabulatedWavelengthPdf(light, strategy.uniform_share)};
}

ArrangedPdf<HeroArrangement, LineWavelengthPdf> ready(const HeroLines& strategy, const Light& light) {
    return {LineWavelengthPdf(light, strategy.uniform_share)};
}

}  // namespace

WavelengthSampler prepare(const WavelengthStrategy& strategy, const WavelengthImportance& light) {
    validate_named(strategy, "wavelengths");
    return std::visit([&light](const auto& value) -> WavelengthSampler { return ready(value, light); }, strategy);
}

double wavelength_pdf(const WavelengthSampler& sampler, double lambda_nm) noexcept {
    return visit_noexcept([lambda_nm](const auto& arranged) { return arranged.pdf.pdf(lambda_nm); }, sampler);
}

double line_mass(const WavelengthSampler& sampler, std::size_t line) noexcept {
    const auto* lines = std::get_if<ArrangedPdf<HeroArrangement, LineWavelengthPdf>>(&sampler);
    return lines == nullptr ? 0.0 : lines->pdf.mass(line);
}

}  // namespace emulsion
