#include "pathtracer/spectrum_tables.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/units.h"
#include "pathtracer/fresnel.h"
#include "spectrum/colorimetry.h"

namespace emulsion {

namespace {

/// The eta, as near to the one given as can be, and the k that have this reflectance at normal incidence.
std::pair<double, double> index_of_reflectance(double reflectance, double eta) {
    const double r = std::clamp(reflectance, 0.0, 0.9999);
    // (1 - eta)^2 + k^2 = r ((1 + eta)^2 + k^2)
    const double k_squared = (r * (1.0 + eta) * (1.0 + eta) - (1.0 - eta) * (1.0 - eta)) / (1.0 - r);
    if (eta > 0.0 && k_squared >= 0.0) return {eta, std::sqrt(k_squared)};
    return {1.0, 2.0 * std::sqrt(r / (1.0 - r))};
}

double luminous_mean(const Spectrum& spectrum) {
    return photometric_integral(spectrum) / photometric_integral(ConstantSpectrum{1.0});
}

}  // namespace

std::uint32_t SpectrumTables::add(Role role, const ScaledSpectrum& spectrum) {
    spectra_.emplace_back(SpectrumTable(spectrum.spectrum, spectrum.scale));
    sources_.push_back({role, spectrum});
    return static_cast<std::uint32_t>(spectra_.size() - 1);
}

std::uint32_t SpectrumTables::add_light(const ScaledSpectrum& light) { return add(Role::light, light); }
std::uint32_t SpectrumTables::add_reflectance(const Spectrum& spectrum) { return add(Role::reflectance, {spectrum}); }
std::uint32_t SpectrumTables::add_index(const Spectrum& spectrum) { return add(Role::index, {spectrum}); }
std::uint32_t SpectrumTables::add_metal(const Spectrum& eta, const Spectrum& k) {
    const std::uint32_t first = add(Role::metal, {eta});
    add(Role::metal, {k});
    return first;
}

void SpectrumTables::prepare(const FixedChannels& channels) {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
        const auto& [role, spectrum] = sources_[i];
        if (role == Role::light) {
            ChannelValues values = light_values(channels, spectrum.spectrum);
            for (double& value : values) value *= spectrum.scale;
            spectra_[i].set_channels(values);
            continue;
        }
        if (role == Role::index) {
            ChannelValues values;
            values.fill(luminous_mean(spectrum.spectrum));
            spectra_[i].set_channels(values);
            continue;
        }
        ChannelValues values = property_values(channels, spectrum.spectrum);
        if (role == Role::reflectance) {
            for (double& value : values) value = std::clamp(value, -1.0, 1.0);
        } else if (role == Role::metal) {
            const Spectrum& k = sources_[i + 1].spectrum.spectrum;
            const auto reflectance = property_values(channels, normal_reflectance(spectrum.spectrum, k));
            ChannelValues absorption{};
            for (std::size_t j = 0; j < values.size(); ++j) {
                std::tie(values[j], absorption[j]) = index_of_reflectance(reflectance[j], values[j]);
            }
            spectra_[++i].set_channels(absorption);
            spectra_[i - 1].set_channels(values);
            continue;
        }
        spectra_[i].set_channels(values);
    }
}

Spectrum normal_reflectance(const Spectrum& eta, const Spectrum& k) {
    DenseSpectrum mirror{static_cast<double>(kMinWavelength_nm), 1.0, {}};
    for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        mirror.value.push_back(fresnel_conductor(1.0, eval(eta, lambda_nm), eval(k, lambda_nm)));
    }
    return mirror;
}

}  // namespace emulsion
