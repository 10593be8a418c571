#include "tonemap/adaptation.h"

#include "core/visit.h"
#include "tonemap/relative_luminance.h"

namespace emulsion {

namespace {

template <class T>
concept GlobalAdaptation = requires(const T& adaptation, ImageView<const XYZ> scene, const SceneLuminance& luminance) {
    adaptation_cdm2(adaptation, scene, luminance, 0);
};

}  // namespace

bool is_local(const Adaptation& adaptation) noexcept {
    return visit_noexcept([]<class T>(const T&) { return !GlobalAdaptation<T>; }, adaptation);
}

AdaptationLuminance adapt(const Adaptation& adaptation, ImageView<const XYZ> scene, const SceneLuminance& luminance,
                          int threads) {
    const auto adapt_to = [&]<class T>(const T& chosen) -> AdaptationLuminance {
        if constexpr (GlobalAdaptation<T>) {
            return {.uniform_cdm2 = adaptation_cdm2(chosen, scene, luminance, threads)};
        } else {
            return {.uniform_cdm2 = luminance.log_average_cdm2(),
                    .local = local_luminance(chosen, relative_luminance<float>(scene, luminance, threads), threads)};
        }
    };
    return std::visit(adapt_to, adaptation);
}

BasicAdaptationLuminance<double> adapt_reference(const Adaptation& adaptation, ImageView<const XYZ> scene,
                                                 const SceneLuminance& luminance) {
    const auto adapt_to = [&]<class T>(const T& chosen) -> BasicAdaptationLuminance<double> {
        if constexpr (GlobalAdaptation<T>) {
            return {.uniform_cdm2 = adaptation_cdm2(chosen, scene, luminance, 1)};
        } else {
            return {.uniform_cdm2 = luminance.log_average_cdm2(),
                    .local = local_luminance_reference(chosen, relative_luminance<double>(scene, luminance, 1))};
        }
    };
    return std::visit(adapt_to, adaptation);
}

}  // namespace emulsion
