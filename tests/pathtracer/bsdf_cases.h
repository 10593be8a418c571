#pragma once
// Every kind of surface with a choice of parameters, for tests that hold for all of them.

#include <ostream>
#include <string>
#include <vector>

#include "pathtracer/bsdf_variant.h"

namespace emulsion::testing {

struct BsdfCase {
    std::string name;
    Bsdf<4> bsdf;
    bool estimated = false;  ///< f_cos is right in the mean only
};
inline void PrintTo(const BsdfCase& c, std::ostream* out) { *out << c.name; }

/// Whose reflectances are those of four wavelengths.
inline SampledSpectrum<4> four(float a, float b, float c, float d) {
    SampledSpectrum<4> s;
    s.value = {a, b, c, d};
    return s;
}

inline ConductorBsdf<4> copper(float alpha_x, float alpha_y) {
    return {four(1.2f, 1.1f, 0.6f, 0.2f), four(2.3f, 2.6f, 2.8f, 3.6f), Ggx<float>(alpha_x, alpha_y),
            std::max(alpha_x, alpha_y) < 1e-3f};
}
inline DielectricBsdf<4> glass(float eta, float alpha_x, float alpha_y) {
    return {SampledSpectrum<4>(eta), Ggx<float>(alpha_x, alpha_y), std::max(alpha_x, alpha_y) < 1e-3f, false};
}
inline CoatedDiffuseBsdf<4> varnish(float eta, float alpha, float thickness) {
    CoatedDiffuseBsdf<4> bsdf;
    bsdf.reflectance = four(0.1f, 0.4f, 0.7f, 0.95f);
    bsdf.eta = eta;
    bsdf.thickness = thickness;
    bsdf.facets = Ggx<float>(alpha, alpha);
    bsdf.smooth_coat = alpha < 1e-3f;
    bsdf.internal_reflectance =
        static_cast<float>(coat_internal_reflectance(static_cast<double>(eta), static_cast<double>(thickness)));
    bsdf.seed = 17;
    return bsdf;
}

inline std::vector<BsdfCase> every_bsdf() {
    std::vector<BsdfCase> cases = {
        {"conductor", copper(0, 0)},
        {"conductor_0_05", copper(0.05f, 0.05f)},
        {"conductor_0_5", copper(0.5f, 0.5f)},
        {"conductor_1", copper(1, 1)},
        {"conductor_brushed", copper(0.1f, 0.6f)},
        {"dielectric", glass(1.5f, 0, 0)},
        {"dielectric_0_1", glass(1.5f, 0.1f, 0.1f)},
        {"dielectric_0_7", glass(1.8f, 0.7f, 0.7f)},
        {"dielectric_below_1", glass(0.7f, 0.3f, 0.3f)},
        {"dielectric_brushed", glass(1.33f, 0.05f, 0.5f)},
        {"thin_dielectric", ThinDielectricBsdf<4>{four(1.3f, 1.5f, 1.7f, 2.4f)}},
        {"diffuse_transmission", DiffuseTransmissionBsdf<4>{four(0.1f, 0.2f, 0.5f, 0), four(0.6f, 0.3f, 0.2f, 0.1f)}},
        {"coated_smooth", varnish(1.5f, 0, 0.01f)},
        {"coated_rough", varnish(1.5f, 0.3f, 0.1f), true},
    };
    DielectricBsdf<4> flint = glass(1.7f, 0, 0);
    flint.eta = four(1.8f, 1.75f, 1.7f, 1.68f);
    flint.disperses = true;
    cases.push_back({"dielectric_dispersing", flint});
    return cases;
}

}  // namespace emulsion::testing
