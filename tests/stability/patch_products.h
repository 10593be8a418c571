#pragma once
// Light that two of the ColorChecker's patches have reflected, as spectra make it and as other models of transport do.

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "pathtracer/model_channels.h"
#include "spectrum/catalogue.h"
#include "spectrum/color_difference.h"
#include "spectrum/colorimetry.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion::stability {

inline constexpr std::size_t kAllPatches = 24, kColouredPatches = 18;

/// The first `count` patches, from dark skin to black; the last six are greys.
inline std::vector<Spectrum> checker_patches(std::size_t count) {
    std::vector<Spectrum> patches;
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) {
        if (entry.name.starts_with("colorchecker-")) patches.emplace_back(spectrum_of(entry));
    }
    patches.resize(count);
    return patches;
}

/// XYZ with Y = 1 for the light itself.
struct Product {
    XYZd spectral, model;
};

/// Of light with every pair of different patches: 153 of 18, 276 of 24.
struct PairProducts {
    std::vector<Product> pair;
    XYZd white;
};

inline PairProducts pair_products(const TransportModel& model, const Spectrum& light,
                                  std::size_t patch_count = kColouredPatches) {
    const std::vector<Spectrum> patches = checker_patches(patch_count);
    const FixedChannels channels = *channels_of(model, {{{light, 1.0}}, patches});
    const ChannelValues lamp = light_values(channels, light);
    std::vector<ChannelValues> r;
    for (const Spectrum& patch : patches) r.push_back(property_values(channels, patch));
    const double white_luminance = xyz_of_radiance(light).y;
    PairProducts products;
    products.white = 1.0 / white_luminance * xyz_of_radiance(light);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        for (std::size_t j = i + 1; j < patches.size(); ++j) {
            Product& product = products.pair.emplace_back();
            product.spectral = xyz_of_reflectance(product_of(patches[i], patches[j]), light);
            for (std::size_t k = 0; k < channels.size(); ++k) {
                const auto& [x, y, z] = channels[k].xyz;
                product.model = product.model + lamp[k] * r[i][k] * r[j][k] / white_luminance * XYZd{x, y, z};
            }
        }
    }
    return products;
}

struct Differences {
    double mean = 0.0, largest = 0.0;
};

/// CIEDE2000 of the products, with the light for white, by the rules of viewing_conditions.h: X, Y and Z below 0 are 0.
inline Differences differences(const PairProducts& products) {
    const ViewingConditions viewing{products.white, 1.0};
    Differences result;
    for (const Product& product : products.pair) {
        const double d = difference(Ciede2000Difference{}, lab_as_viewed(product.spectral, viewing),
                                    lab_as_viewed(product.model, viewing));
        result.mean += d / static_cast<double>(products.pair.size());
        result.largest = std::max(result.largest, d);
    }
    return result;
}

}  // namespace emulsion::stability
