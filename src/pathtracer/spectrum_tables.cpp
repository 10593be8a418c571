#include "pathtracer/spectrum_tables.h"

#include "spectrum/colorimetry.h"

namespace emulsion {

namespace {

RGB to_rgb(const std::array<double, 3>& v) noexcept {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

}  // namespace

SpectrumTables::SpectrumTables()
    : rec709_(reflectance_rgb(rgb_space("sRGB"))), rgb_from_xyz_(rgb_from_xyz(rgb_space("sRGB"))) {}

std::uint32_t SpectrumTables::add_property(const Spectrum& spectrum) {
    spectra_.emplace_back(SpectrumTable(spectrum), to_rgb(weighted_sums(rec709_.rgb_weights, spectrum)));
    return static_cast<std::uint32_t>(spectra_.size() - 1);
}

std::uint32_t SpectrumTables::add_light(const ScaledSpectrum& light) {
    const XYZd xyz = xyz_of_radiance(light.spectrum);
    const std::array<double, 3> scaled = {xyz.x * light.scale, xyz.y * light.scale, xyz.z * light.scale};
    spectra_.emplace_back(SpectrumTable(light.spectrum, light.scale), to_rgb(rgb_from_xyz_ * scaled));
    return static_cast<std::uint32_t>(spectra_.size() - 1);
}

}  // namespace emulsion
