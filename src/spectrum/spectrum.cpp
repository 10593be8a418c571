#include "spectrum/spectrum.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/core.h>

#include "core/visit.h"

namespace emulsion {

namespace {

// What the alternatives without jumps and knots need no functions of their own for.
template <class T>
constexpr bool kHasNoKnots =
    std::same_as<T, ConstantSpectrum> || std::same_as<T, SigmoidSpectrum> || std::same_as<T, BlackbodySpectrum>;

template <class T>
double limit_of(const T& spectrum, double lambda_nm, Side side) noexcept {
    if constexpr (kHasNoKnots<T> || std::same_as<T, LineSpectrum>) {
        return eval(spectrum, lambda_nm);
    } else if constexpr (std::same_as<T, RgbIlluminantSpectrum>) {
        return spectrum.scale * eval(spectrum.sigmoid, lambda_nm) * limit(spectrum.illuminant, lambda_nm, side);
    } else {
        return limit(spectrum, lambda_nm, side);
    }
}

template <class T>
std::vector<double> knots_of(const T& spectrum) {
    if constexpr (kHasNoKnots<T>) {
        return {};
    } else if constexpr (std::same_as<T, RgbIlluminantSpectrum>) {
        return knots_nm(spectrum.illuminant);
    } else {
        return knots_nm(spectrum);
    }
}

std::optional<int> degree_of(const ConstantSpectrum&) noexcept { return 0; }
std::optional<int> degree_of(const PiecewiseLinearSpectrum&) noexcept { return 1; }
std::optional<int> degree_of(const DenseSpectrum&) noexcept { return 1; }
std::optional<int> degree_of(const DaylightSpectrum&) noexcept { return 1; }
std::optional<int> degree_of(const BlackbodySpectrum&) noexcept { return std::nullopt; }
std::optional<int> degree_of(const SigmoidSpectrum&) noexcept { return std::nullopt; }
std::optional<int> degree_of(const RgbIlluminantSpectrum&) noexcept { return std::nullopt; }

std::optional<int> degree_of(const LineSpectrum& spectrum) noexcept {
    return spectrum.gaussian.empty() ? std::optional<int>(0) : std::nullopt;
}

std::optional<int> degree_of(const ProductSpectrum& spectrum) noexcept {
    int degree = 0;
    for (const Spectrum& factor : spectrum.factor) {
        const std::optional<int> more = polynomial_degree(factor);
        if (!more) return std::nullopt;
        degree += *more;
    }
    return degree;
}

std::optional<int> degree_of(const SumSpectrum& spectrum) noexcept {
    int degree = 0;
    for (const Spectrum& term : spectrum.term) {
        const std::optional<int> other = polynomial_degree(term);
        if (!other) return std::nullopt;
        degree = std::max(degree, *other);
    }
    return degree;
}

template <class T>
std::vector<Line> lines_of(const T& spectrum) {
    if constexpr (std::same_as<T, LineSpectrum>) {
        std::vector<Line> lines = spectrum.line;
        std::sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.lambda_nm < b.lambda_nm; });
        return lines;
    } else if constexpr (std::same_as<T, ProductSpectrum> || std::same_as<T, SumSpectrum>) {
        return delta_lines(spectrum);
    } else {
        return {};
    }
}

}  // namespace

void eval(const Spectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    // An assignment that ran out of memory leaves a spectrum without a value.
    if (spectrum.valueless_by_exception()) {
        std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
        return;
    }
    visit_noexcept([&](const auto& alternative) { eval(alternative, at, values); }, spectrum);
}

double eval(const Spectrum& spectrum, double lambda_nm) noexcept {
    if (spectrum.valueless_by_exception()) return std::numeric_limits<double>::quiet_NaN();
    return visit_noexcept([lambda_nm](const auto& alternative) { return eval(alternative, lambda_nm); }, spectrum);
}

void eval(const Spectrum& spectrum, std::span<const double> lambda_nm, std::span<double> values) {
    if (lambda_nm.size() != values.size()) {
        throw std::invalid_argument(fmt::format("spectrum: {} wavelengths and room for {} values: expected as many",
                                                lambda_nm.size(), values.size()));
    }
    eval(spectrum, OffsetWavelengths{0.0, lambda_nm}, values);
}

double limit(const Spectrum& spectrum, double lambda_nm, Side side) noexcept {
    if (spectrum.valueless_by_exception()) return std::numeric_limits<double>::quiet_NaN();
    return visit_noexcept([=](const auto& alternative) { return limit_of(alternative, lambda_nm, side); }, spectrum);
}

std::vector<double> knots_nm(const Spectrum& spectrum) {
    return std::visit([](const auto& alternative) { return knots_of(alternative); }, spectrum);
}

std::optional<int> polynomial_degree(const Spectrum& spectrum) noexcept {
    if (spectrum.valueless_by_exception()) return std::nullopt;
    return visit_noexcept([](const auto& alternative) { return degree_of(alternative); }, spectrum);
}

std::vector<Line> delta_lines(const Spectrum& spectrum) {
    return std::visit([](const auto& alternative) { return lines_of(alternative); }, spectrum);
}

Spectrum product_of(Spectrum a, Spectrum b, double scale) {
    ProductSpectrum product;
    product.factor.reserve(2);
    product.factor.push_back(std::move(a));
    product.factor.push_back(std::move(b));
    product.scale = scale;
    return product;
}

Spectrum sum_of(Spectrum a, Spectrum b, double weight_a, double weight_b) {
    SumSpectrum sum;
    sum.term.reserve(2);
    sum.term.push_back(std::move(a));
    sum.term.push_back(std::move(b));
    sum.weight = {weight_a, weight_b};
    return sum;
}

Spectrum scaled(Spectrum spectrum, double scale) {
    ProductSpectrum product;
    product.factor.push_back(std::move(spectrum));
    product.scale = scale;
    return product;
}

void validate(const Spectrum& spectrum) {
    std::visit([](const auto& alternative) { validate(alternative); }, spectrum);
}

}  // namespace emulsion
