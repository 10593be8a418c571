#include "chart/uplift_errors.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "spectrum/ciede2000_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/srgb_transfer.h"

namespace emulsion {

void for_each_colour(int levels, const std::function<void(const RGBd&)>& visit) {
    const auto linear = [&](int i) { return decode(SrgbTransfer{}, static_cast<double>(i) / (levels - 1)); };
    for (int i = 0; i < levels * levels * levels; ++i) {
        visit({linear(i % levels), linear(i / levels % levels), linear(i / levels / levels)});
    }
}

std::vector<double> round_trips(const RgbUplift& uplift, const RgbSpace& space, int levels) {
    const Matrix3 matrix = xyz_from_rgb(space);
    const auto lab = [&](const RGBd& rgb) {
        const auto xyz = matrix * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        return lab_from_xyz({xyz[0], xyz[1], xyz[2]}, xyz_of(space.white));
    };
    std::vector<double> differences;
    for_each_colour(levels, [&](const RGBd& rgb) {
        differences.push_back(difference(Ciede2000Difference{}, lab(rgb), lab(uplift.rgb_of(uplift.reflectance(rgb)))));
    });
    return differences;
}

std::vector<Spectrum> measured_reflectances() {
    std::vector<Spectrum> reflectances;
    for (const std::string_view table : {"colorchecker_reflectance", "reflectances_ampas24_5nm"}) {
        for (const std::string& name : data_table(table).column_names) {
            if (name == "wavelength") continue;
            PiecewiseLinearSpectrum reflectance = tabulated_spectrum(table, name);
            reflectance.extrapolation = Extrapolation::hold;
            reflectances.emplace_back(std::move(reflectance));
        }
    }
    return reflectances;
}

std::vector<double> drifts(const RgbUplift& uplift, std::string_view illuminant) {
    const Spectrum light = tabulated_spectrum("illuminants_5nm", illuminant);
    const XYZd white = xyz_of_reflectance(ConstantSpectrum{1.0}, light);
    const auto lab = [&](const Spectrum& reflectance) {
        return lab_from_xyz(xyz_of_reflectance(reflectance, light), white);
    };
    std::vector<double> differences;
    for (const Spectrum& original : measured_reflectances()) {
        const RGBd rgb = uplift.rgb_of(original);
        if (std::min({rgb.r, rgb.g, rgb.b}) < 0.0 || std::max({rgb.r, rgb.g, rgb.b}) > 1.0) continue;
        differences.push_back(difference(Ciede2000Difference{}, lab(original), lab(uplift.reflectance(rgb))));
    }
    return differences;
}

}  // namespace emulsion
