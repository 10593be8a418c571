#include "spectrum/chromatic_adaptation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "core/parameters.h"

namespace emulsion {

namespace {

constexpr Matrix3 kBradford = {
    {{{{0.8951, 0.2664, -0.1614}}, {{-0.7502, 1.7135, 0.0367}}, {{0.0389, -0.0685, 1.0296}}}}};
constexpr Matrix3 kXyz = {{{{{1.0, 0.0, 0.0}}, {{0.0, 1.0, 0.0}}, {{0.0, 0.0, 1.0}}}}};
constexpr Matrix3 kHuntPointerEstevez = {
    {{{{0.40024, 0.70760, -0.08081}}, {{-0.22630, 1.16532, 0.04570}}, {{0.0, 0.0, 0.91822}}}}};
constexpr Matrix3 kCat02 = {{{{{0.7328, 0.4296, -0.1624}}, {{-0.7036, 1.6975, 0.0061}}, {{0.0030, 0.0136, 0.9834}}}}};
constexpr Matrix3 kCat16 = {
    {{{{0.401288, 0.650173, -0.051461}}, {{-0.250268, 1.204414, 0.045854}}, {{-0.002079, 0.048952, 0.953127}}}}};

const Matrix3& matrix_of(const BradfordAdaptation& /*method*/) noexcept { return kBradford; }
const Matrix3& matrix_of(const XyzScalingAdaptation& /*method*/) noexcept { return kXyz; }
const Matrix3& matrix_of(const VonKriesAdaptation& /*method*/) noexcept { return kHuntPointerEstevez; }
const Matrix3& matrix_of(const Cat02Adaptation& /*method*/) noexcept { return kCat02; }
const Matrix3& matrix_of(const Cat16Adaptation& /*method*/) noexcept { return kCat16; }

/// The responses to a white, all positive. `which` names it in the message.
std::array<double, 3> responses_of_white(const ChromaticAdaptation& method, const XYZd& white, const char* which) {
    const auto responses = cone_from_xyz(method) * std::array<double, 3>{white.x, white.y, white.z};
    for (const double response : responses) {
        if (response > 0.0 && std::isfinite(response)) continue;
        throw std::invalid_argument("adaptation " + to_text(method) + ": " + which + " XYZ " + number_text(white.x) +
                                    ", " + number_text(white.y) + ", " + number_text(white.z) + " has the responses " +
                                    number_text(responses[0]) + ", " + number_text(responses[1]) + ", " +
                                    number_text(responses[2]) + ": all must be in (0, inf)");
    }
    return responses;
}

}  // namespace

Matrix3 cone_from_xyz(const ChromaticAdaptation& method) noexcept {
    return visit_noexcept([](const auto& chosen) { return matrix_of(chosen); }, method);
}

Matrix3 adaptation_matrix(const ChromaticAdaptation& method, const XYZd& from_white, const XYZd& to_white,
                          double degree) {
    check_range(degree, {0.0, 1.0}, "adaptation " + to_text(method) + ": degree");
    const auto from = responses_of_white(method, from_white, "from-white");
    const auto to = responses_of_white(method, to_white, "to-white");
    if (from == to || degree == 0.0) return kXyz;

    const Matrix3 cone = cone_from_xyz(method);
    Matrix3 scaled = cone;
    for (std::size_t row = 0; row < 3; ++row) {
        const double gain = degree * (to[row] / from[row]) + (1.0 - degree);
        for (double& element : scaled.m[row]) element *= gain;
    }
    return inverse(cone) * scaled;
}

}  // namespace emulsion
