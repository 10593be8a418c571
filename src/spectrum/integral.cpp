#include "spectrum/integral.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include <fmt/core.h>

#include "spectrum/integral_panels.h"

namespace emulsion {

namespace {

/// Wavelengths in (from_nm, to_nm) near which the sigmoids in a spectrum change fastest.
void append_steep_places(const Spectrum& spectrum, double from_nm, double to_nm, std::vector<double>& places) {
    const auto append = [&](const SigmoidSpectrum& sigmoid) {
        const std::vector<double> more = steep_places_nm(sigmoid, from_nm, to_nm);
        places.insert(places.end(), more.begin(), more.end());
    };
    if (const auto* sigmoid = std::get_if<SigmoidSpectrum>(&spectrum)) append(*sigmoid);
    if (const auto* light = std::get_if<RgbIlluminantSpectrum>(&spectrum)) append(light->sigmoid);
    if (const auto* product = std::get_if<ProductSpectrum>(&spectrum)) {
        for (const Spectrum& factor : product->factor) append_steep_places(factor, from_nm, to_nm, places);
    }
    if (const auto* sum = std::get_if<SumSpectrum>(&spectrum)) {
        for (const Spectrum& term : sum->term) append_steep_places(term, from_nm, to_nm, places);
    }
}

void sort_and_unite(std::vector<double>& cuts) {
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
}

/// `cuts` and everything at which the product of the factors has to be cut, from from_nm to to_nm; increasing.
std::vector<double> all_cuts(SpectrumReferences factors, std::vector<double> cuts, double from_nm, double to_nm) {
    cuts.push_back(from_nm);
    cuts.push_back(to_nm);
    for (const Spectrum& factor : factors) {
        const std::vector<double> more = integration_cuts_nm(factor, from_nm, to_nm);
        cuts.insert(cuts.end(), more.begin(), more.end());
    }
    sort_and_unite(cuts);
    return cuts;
}

std::optional<int> degree_of_product(SpectrumReferences factors) noexcept {
    int sum = 0;
    for (const Spectrum& factor : factors) {
        const std::optional<int> degree = polynomial_degree(factor);
        if (!degree) return std::nullopt;
        sum += *degree;
    }
    return sum;
}

/// At most as many wavelengths as a rule has points.
void eval_product(SpectrumReferences factors, const OffsetWavelengths& at, std::span<double> values) noexcept {
    std::fill(values.begin(), values.end(), 1.0);
    WavelengthBlock factor_values{};
    for (const Spectrum& factor : factors) {
        eval(factor, at, std::span(factor_values).first(at.size()));
        for (std::size_t i = 0; i < at.size(); ++i) values[i] *= factor_values[i];
    }
}

/// Checks the factors, and finds the lines without width of their product.
std::vector<Line> lines_of_product(SpectrumReferences factors) {
    std::vector<const Spectrum*> pointers;
    for (const Spectrum& factor : factors) {
        validate(factor);
        pointers.push_back(&factor);
    }
    return delta_lines_of_product(pointers);
}

void require_range(double from_nm, double to_nm) {
    if (std::isfinite(from_nm) && std::isfinite(to_nm) && from_nm <= to_nm) return;
    throw std::invalid_argument(
        fmt::format("integral: from {} nm to {} nm: expected finite numbers in order", from_nm, to_nm));
}

}  // namespace

std::vector<double> integration_cuts_nm(const Spectrum& spectrum, double from_nm, double to_nm) {
    const std::vector<double> knots = knots_nm(spectrum);
    const auto first = std::upper_bound(knots.begin(), knots.end(), from_nm);
    std::vector<double> cuts(first, std::lower_bound(first, knots.end(), to_nm));
    append_steep_places(spectrum, from_nm, to_nm, cuts);
    sort_and_unite(cuts);
    return cuts;
}

double integral(const Spectrum& spectrum, double from_nm, double to_nm) {
    return integral_of_product({spectrum}, from_nm, to_nm);
}

double integral_of_product(SpectrumReferences factors, double from_nm, double to_nm) {
    require_range(from_nm, to_nm);
    const std::vector<Line> lines = lines_of_product(factors);
    const auto integrand = [&](const OffsetWavelengths& at, std::span<Sums<1>> values) {
        WavelengthBlock product{};
        eval_product(factors, at, std::span(product).first(at.size()));
        for (std::size_t i = 0; i < at.size(); ++i) values[i][0] = product[i];
    };
    double sum = integral_over_cuts<1>(all_cuts(factors, {}, from_nm, to_nm), degree_of_product(factors), integrand)[0];
    for (const Line& line : lines) {
        if (line.lambda_nm >= from_nm && line.lambda_nm <= to_nm) sum += line.power;
    }
    return sum;
}

XYZd integral_with_observer(SpectrumReferences factors, const Observer& observer) {
    const double from_nm = observer.first_nm, to_nm = observer.last_nm();
    const std::vector<Line> lines = lines_of_product(factors);
    std::vector<double> cuts;
    for (int lambda_nm = observer.first_nm; lambda_nm <= observer.last_nm(); ++lambda_nm) cuts.push_back(lambda_nm);
    std::optional<int> degree = degree_of_product(factors);
    if (degree) ++*degree;

    const auto integrand = [&](const OffsetWavelengths& at, std::span<Sums<3>> values) {
        WavelengthBlock product{};
        eval_product(factors, at, std::span(product).first(at.size()));
        for (std::size_t i = 0; i < at.size(); ++i) {
            const XYZd weighted = product[i] * eval(observer, at[i]);
            values[i] = {weighted.x, weighted.y, weighted.z};
        }
    };
    const auto [x, y, z] = integral_over_cuts<3>(all_cuts(factors, std::move(cuts), from_nm, to_nm), degree, integrand);
    XYZd sum{x, y, z};
    for (const Line& line : lines) sum = sum + line.power * eval(observer, line.lambda_nm);
    return sum;
}

}  // namespace emulsion
