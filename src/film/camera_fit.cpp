#include "film/camera_fit.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "spectrum/catalogue.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/data_table.h"
#include "spectrum/integral.h"

namespace emulsion {

namespace {

using Triple = std::array<double, 3>;

/// What camera and observer make of one surface.
struct Swatch {
    Triple camera, target;
};

Triple triple(const XYZd& xyz) { return {xyz.x, xyz.y, xyz.z}; }

double luminance_of(const Spectrum& illuminant, const Observer& observer) {
    const double luminance = integral_with_observer({illuminant}, observer).y;
    if (luminance > 0.0 && std::isfinite(luminance)) return luminance;
    throw std::invalid_argument("camera training: the illuminant's integral with ybar is " + std::to_string(luminance) +
                                ", expected a finite number > 0");
}

std::vector<Swatch> swatches(const Observer& camera, const Observer& observer, const Spectrum& illuminant,
                             const Spectrum& target_illuminant) {
    const double camera_scale = 1.0 / luminance_of(illuminant, observer);
    const double target_scale = 1.0 / luminance_of(target_illuminant, observer);
    std::vector<Swatch> all;
    for (const std::string& name : camera_training_names()) {
        const Spectrum reflectance = catalogue_spectrum(name);
        all.push_back({triple(camera_scale * integral_with_observer({reflectance, illuminant}, camera)),
                       triple(target_scale * integral_with_observer({reflectance, target_illuminant}, observer))});
    }
    return all;
}

/// Root mean square of each channel of the camera.
Triple sizes(const std::vector<Swatch>& all) {
    Triple size{};
    for (const Swatch& swatch : all) {
        for (std::size_t i = 0; i < 3; ++i) size[i] += swatch.camera[i] * swatch.camera[i];
    }
    for (double& value : size) value = std::sqrt(value / static_cast<double>(all.size()));
    return size;
}

/// T C^t (C C^t)^-1 by normal equations, the channels brought to the size 1 first.
Matrix3 least_squares(const std::vector<Swatch>& all) {
    constexpr double kSmallestDeterminant = 1e-12;  // of channels of size 1; 1 if they have nothing in common
    const auto count = static_cast<double>(all.size());
    const Triple size = sizes(all);
    Matrix3 square, mixed;
    for (const Swatch& swatch : all) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                square.m[i][j] += (swatch.camera[i] / size[i]) * (swatch.camera[j] / size[j]) / count;
                mixed.m[i][j] += swatch.target[i] * (swatch.camera[j] / size[j]) / count;
            }
        }
    }
    if (!(determinant(square) > kSmallestDeterminant)) {
        throw std::invalid_argument("the determinant of its channels' products is " +
                                    std::to_string(determinant(square)) +
                                    ", expected more than 1e-12: over the training reflectances r, g and b are "
                                    "linearly dependent");
    }
    Matrix3 matrix = mixed * inverse(square);
    for (auto& row : matrix.m) {
        for (std::size_t j = 0; j < 3; ++j) row[j] /= size[j];
    }
    return matrix;
}

void add_residuals(const std::vector<Swatch>& all, const XYZd& white, CameraFit& fit) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Triple seen = fit.xyz_from_camera * all[i].camera, &target = all[i].target;
        const double off = difference(Ciede2000Difference{}, lab_from_xyz({target[0], target[1], target[2]}, white),
                                      lab_from_xyz({seen[0], seen[1], seen[2]}, white));
        fit.mean_ciede2000 += off / static_cast<double>(all.size());
        if (i > 0 && off <= fit.max_ciede2000) continue;
        fit.max_ciede2000 = off;
        fit.worst = camera_training_names()[i];
    }
    fit.reflectance_count = static_cast<int>(all.size());
}

std::vector<std::string> make_training_names() {
    std::vector<std::string> names;
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) {
        if (entry.table == "colorchecker_reflectance" || entry.table == "munsell_cqs_saturated_5nm" ||
            entry.table == "reflectances_ampas24_5nm") {
            names.push_back(entry.name);
        }
    }
    return names;
}

}  // namespace

const std::vector<std::string>& camera_training_names() {
    static const std::vector<std::string> names = make_training_names();
    return names;
}

CameraFit fit_camera(const CameraResponse& response, const Observer& observer, const CameraTraining& training) {
    const Observer camera = at_whole_nm(response);
    validate(training.illuminant);
    const Spectrum& target_illuminant = training.target_illuminant ? *training.target_illuminant : training.illuminant;
    validate(target_illuminant);

    const std::vector<Swatch> all = swatches(camera, observer, training.illuminant, target_illuminant);
    CameraFit fit;
    try {
        fit.xyz_from_camera = least_squares(all);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("camera " + response.name + ": " + error.what());
    }
    const XYZd light = integral_with_observer({target_illuminant}, observer);
    add_residuals(all, (1.0 / light.y) * light, fit);
    return fit;
}

}  // namespace emulsion
