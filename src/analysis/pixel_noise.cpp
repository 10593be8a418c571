#include "analysis/pixel_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/low_discrepancy.h"
#include "core/random.h"
#include "core/units.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/observer.h"
#include "spectrum/sampled_spectrum.h"
#include "spectrum/spectrum_table.h"

namespace emulsion {

namespace {

/// The most paths that a picture is drawn of; of more, this many and their deviation made smaller.
constexpr double kMostPaths = 128.0;

double density(const WavelengthSampler& sampler, double u, double& lambda_nm) {
    return std::visit(
        [&](const auto& arranged) {
            const auto sample = arranged.pdf.exact(u);
            lambda_nm = sample.lambda_nm;
            return sample.pdf;
        },
        sampler);
}

/// Pictures of a pixel; `colour_of_path(random, next_u, dispersed)` says what a path that brings light shows.
template <class ColourOfPath>
double mean_square(const PixelLight& light, const PixelPaths& paths, const ViewingConditions& viewing,
                   const NoiseDraws& draws, const ColourOfPath& colour_of_path) {
    const double count = std::max(1.0, std::round(std::min(paths.count, kMostPaths)));
    const auto path_count = static_cast<std::uint32_t>(count);
    const double brings_light = 1.0 / (1.0 + light.path_variance);
    const double less = std::sqrt(count / paths.count);
    const Lab expected = lab_as_viewed(light.xyz, viewing);
    double sum = 0.0;
    for (int picture = 0; picture < draws.pictures; ++picture) {
        const std::uint64_t seed = hash_combine(draws.seed, static_cast<std::uint64_t>(picture));
        Pcg32 random(seed);
        XYZd pixel{};
        for (std::uint32_t path = 0; path < path_count; ++path) {
            if (static_cast<double>(random.next_float()) >= brings_light) continue;
            const bool dispersed = static_cast<double>(random.next_float()) < light.dispersed_share;
            std::uint64_t dimension = 0;
            const auto next_u = [&] {
                const float u = random.next_float();
                if (paths.numbers == PixelPaths::Numbers::independent) return u;
                const auto order = static_cast<std::uint32_t>(hash_combine(seed, ++dimension));
                const auto stratum = static_cast<float>(permuted(path, path_count, order));
                return std::min((stratum + u) / static_cast<float>(count), 0x1.fffffep-1f);
            };
            pixel = pixel + colour_of_path(next_u, dispersed);
        }
        pixel = 1.0 / (brings_light * count) * pixel;
        const XYZd shown = light.xyz + less * (pixel + -1.0 * light.xyz);
        const double e = difference(Ciede2000Difference{}, expected, lab_as_viewed(shown, viewing));
        sum += e * e;
    }
    return sum / draws.pictures;
}

template <int N>
double wavelength_noise_of(const PixelLight& light, std::span<const XYZd> by_number, const WavelengthSampler& sampler,
                           const PixelPaths& paths, const ViewingConditions& viewing, const NoiseDraws& draws) {
    return std::visit(
        [&]<class Arrangement, class Pdf>(const ArrangedPdf<Arrangement, Pdf>& /*arranged*/) {
            const auto colour_of_path = [&](const auto& next_u, bool dispersed) {
                const WavelengthNumbers<N> numbers = Arrangement::template numbers<N>(next_u);
                std::size_t kept = N;
                if (dispersed) kept = 1;
                XYZd sum{};
                for (std::size_t i = 0; i < kept; ++i) {
                    const auto cell = static_cast<std::size_t>(numbers[i] * static_cast<double>(by_number.size()));
                    sum = sum + by_number[cell];
                }
                return 1.0 / static_cast<double>(kept) * sum;
            };
            return mean_square(light, paths, viewing, draws, colour_of_path);
        },
        sampler);
}

}  // namespace

WavelengthWeights::WavelengthWeights(WavelengthSampler sampler, const Spectrum& light) : sampler_(std::move(sampler)) {
    constexpr std::size_t kLastCell = kMaxWavelength_nm - kMinWavelength_nm - 1;
    const SpectrumTable table(light);  // as paths see it: a line has the nanometre that it lies in
    for (std::size_t i = 0; i < kNumberCells; ++i) {
        double lambda_nm = 0.0;
        const double pdf = density(sampler_, (static_cast<double>(i) + 0.5) / kNumberCells, lambda_nm);
        const SpectrumTableIndex<1> index({static_cast<float>(lambda_nm)});
        const double above = lambda_nm - kMinWavelength_nm;
        const std::size_t node = std::min(static_cast<std::size_t>(above), kLastCell);
        cells_.push_back({node, above - static_cast<double>(node),
                          static_cast<double>(table.at(index)[0]) / pdf * eval(cie_1931_2deg(), lambda_nm)});
    }
}

std::vector<XYZd> WavelengthWeights::by_number(std::span<const double> ratio) const {
    std::vector<XYZd> result;
    result.reserve(cells_.size());
    for (const Cell& cell : cells_) {
        const double below = ratio[cell.node], next = ratio[cell.node + 1];
        result.push_back((below + cell.above * (next - below)) * cell.weight);
    }
    return result;
}

double channel_noise(const PixelLight& light, const PixelPaths& paths, const ViewingConditions& viewing,
                     const NoiseDraws& draws) {
    return mean_square(light, paths, viewing, draws,
                       [&](const auto& /*next_u*/, bool /*dispersed*/) { return light.xyz; });
}

double wavelength_noise(const PixelLight& light, std::span<const XYZd> by_number, const WavelengthSampler& sampler,
                        int wavelengths, const PixelPaths& paths, const ViewingConditions& viewing,
                        const NoiseDraws& draws) {
    double result = 0.0;
    for_each_wavelength_count([&]<int N>() {
        if (N == wavelengths) {
            result = wavelength_noise_of<N>(light, by_number, sampler, paths, viewing, draws);
        }
    });
    return result;
}

}  // namespace emulsion
