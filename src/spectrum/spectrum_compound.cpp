#include "spectrum/spectrum_compound.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include <fmt/core.h>

#include "spectrum/spectrum.h"
#include "spectrum/spectrum_checks.h"

namespace emulsion {

namespace {

std::vector<double> union_of_knots(const std::vector<Spectrum>& parts) {
    std::vector<double> knots;
    for (const Spectrum& part : parts) {
        const std::vector<double> more = knots_nm(part);
        knots.insert(knots.end(), more.begin(), more.end());
    }
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    return knots;
}

bool by_wavelength(const Line& a, const Line& b) noexcept { return a.lambda_nm < b.lambda_nm; }

/// Increasing, with the powers of lines at one wavelength added up.
std::vector<Line> merged(std::vector<Line> lines) {
    std::stable_sort(lines.begin(), lines.end(), by_wavelength);
    std::vector<Line> result;
    for (const Line& line : lines) {
        if (!result.empty() && result.back().lambda_nm == line.lambda_nm) {
            result.back().power += line.power;
        } else {
            result.push_back(line);
        }
    }
    return result;
}

std::vector<const Spectrum*> pointers_to(const std::vector<Spectrum>& spectra) {
    std::vector<const Spectrum*> pointers;
    pointers.reserve(spectra.size());
    for (const Spectrum& spectrum : spectra) pointers.push_back(&spectrum);
    return pointers;
}

}  // namespace

void eval(const ProductSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    for_each_block(at, values, [&](const OffsetWavelengths& block, std::span<double> product, std::span<double> part) {
        std::fill(product.begin(), product.end(), spectrum.scale);
        for (const Spectrum& factor : spectrum.factor) {
            eval(factor, block, part);
            for (std::size_t i = 0; i < block.size(); ++i) product[i] *= part[i];
        }
    });
}

void eval(const SumSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    for_each_block(at, values, [&](const OffsetWavelengths& block, std::span<double> sum, std::span<double> part) {
        std::fill(sum.begin(), sum.end(), 0.0);
        for (std::size_t j = 0; j < spectrum.term.size(); ++j) {
            eval(spectrum.term[j], block, part);
            for (std::size_t i = 0; i < block.size(); ++i) sum[i] += spectrum.weight[j] * part[i];
        }
    });
}

double limit(const ProductSpectrum& spectrum, double lambda_nm, Side side) noexcept {
    double value = spectrum.scale;
    for (const Spectrum& factor : spectrum.factor) value *= limit(factor, lambda_nm, side);
    return value;
}

double limit(const SumSpectrum& spectrum, double lambda_nm, Side side) noexcept {
    double value = 0.0;
    for (std::size_t j = 0; j < spectrum.term.size(); ++j) {
        value += spectrum.weight[j] * limit(spectrum.term[j], lambda_nm, side);
    }
    return value;
}

std::vector<double> knots_nm(const ProductSpectrum& spectrum) { return union_of_knots(spectrum.factor); }

std::vector<double> knots_nm(const SumSpectrum& spectrum) { return union_of_knots(spectrum.term); }

std::vector<Line> delta_lines_of_product(std::span<const Spectrum* const> factors) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        for (Line line : delta_lines(*factors[i])) {
            for (std::size_t j = 0; j < factors.size(); ++j) {
                if (j != i) line.power *= eval(*factors[j], line.lambda_nm);
            }
            lines.push_back(line);
        }
    }
    std::sort(lines.begin(), lines.end(), by_wavelength);
    const auto twice = std::adjacent_find(lines.begin(), lines.end(),
                                          [](const Line& a, const Line& b) { return a.lambda_nm == b.lambda_nm; });
    if (twice != lines.end()) {
        throw_bad_spectrum("product of spectra: lines without width in two factors, lambda_nm", twice->lambda_nm,
                           "lines at different wavelengths, or Gaussian ones");
    }
    return lines;
}

std::vector<Line> delta_lines(const ProductSpectrum& spectrum) {
    std::vector<Line> lines = delta_lines_of_product(pointers_to(spectrum.factor));
    for (Line& line : lines) line.power *= spectrum.scale;
    return lines;
}

std::vector<Line> delta_lines(const SumSpectrum& spectrum) {
    std::vector<Line> lines;
    for (std::size_t j = 0; j < spectrum.term.size(); ++j) {
        for (const Line& line : delta_lines(spectrum.term[j])) {
            lines.push_back({line.lambda_nm, spectrum.weight[j] * line.power});
        }
    }
    return merged(std::move(lines));
}

void validate(const ProductSpectrum& spectrum) {
    require_finite("product of spectra: scale", spectrum.scale);
    for (const Spectrum& factor : spectrum.factor) validate(factor);
    (void)delta_lines_of_product(pointers_to(spectrum.factor));
}

void validate(const SumSpectrum& spectrum) {
    if (spectrum.weight.size() != spectrum.term.size()) {
        throw std::invalid_argument(fmt::format("sum of spectra: {} terms and {} weights: expected as many",
                                                spectrum.term.size(), spectrum.weight.size()));
    }
    for (std::size_t j = 0; j < spectrum.term.size(); ++j) {
        require_finite(fmt::format("sum of spectra: weight[{}]", j), spectrum.weight[j]);
        validate(spectrum.term[j]);
    }
}

}  // namespace emulsion
