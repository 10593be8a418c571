#pragma once
// What the parameter tables of the filters share.

#include "core/parameters.h"

namespace emulsion {

template <class F>
[[nodiscard]] constexpr Parameter<F> x_radius_parameter(float F::*member) noexcept {
    return {"x-radius", member, kPositiveFinite, "px", "half-width of the support"};
}
template <class F>
[[nodiscard]] constexpr Parameter<F> y_radius_parameter(float F::*member) noexcept {
    return {"y-radius", member, kPositiveFinite, "px", "half-height of the support"};
}

}  // namespace emulsion
